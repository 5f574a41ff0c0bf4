/* The bridge to OpenVDB (medium/vdb_bridge.h), a module. Called by the jobs of
 * murk_subprocess_do(). No exception leaves this file. */
extern "C" {
#include "medium/vdb_bridge.h"
#include "base/number.h"
#include "medium/grid_choice.h"
}

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/* openvdb::initialize() crashes if the symbols of OpenVDB's templates are
 * hidden. */
#pragma GCC visibility push(default)
#include <nanovdb/util/OpenToNanoVDB.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Prune.h>
#pragma GCC visibility pop
#include <tbb/global_control.h>

namespace
{

/* Largest index: the end of a cell must fit into int32_t (medium/tree.h). */
const int64_t INDEX_MAX = int64_t(1) << 30;

struct Place {
    const char *where;
    murk_error *err;
};

/* Converts exceptions to a status, and lets no thread start: each thread
 * would take a stack and an arena out of the memory limit of the subprocess,
 * and whether a file can be read would depend on the number of processors. */
template <typename Work> murk_status guard(const Place &at, Work work)
{
    try {
        const tbb::global_control alone(
            tbb::global_control::max_allowed_parallelism, 1);
        return work();
    } catch (const std::bad_alloc &) {
        return murk_fail(at.err, MURK_BAD_FILE, at.where,
                         "asks for more memory than a file of its size may: "
                         "malformed, or too large");
    } catch (const std::exception &e) {
        return murk_fail(at.err, MURK_BAD_FILE, at.where,
                         "malformed OpenVDB file: %.300s", e.what());
    } catch (...) {
        return murk_fail(at.err, MURK_BAD_FILE, at.where,
                         "malformed OpenVDB file");
    }
}

struct Entry {
    std::string unique, name, type;
    bool is_level_set, is_linear;
};

/* Lists the grids of a file without reading any tree. */
std::vector<Entry> list_grids(openvdb::io::File &file)
{
    std::vector<Entry> entries;
    for (auto it = file.beginName(); it != file.endName(); ++it) {
        Entry entry{*it, *it, "unreadable values", false, true};
        try {
            const auto grid = file.readGridMetadata(*it);
            entry.name = grid->getName();
            entry.type = grid->valueType();
            entry.is_level_set =
                grid->getGridClass() == openvdb::GRID_LEVEL_SET;
            entry.is_linear = grid->transform().isLinear();
        } catch (const openvdb::Exception &) {
            /* a type that is not registered: listed, but refused if it is
             * selected */
        }
        entries.push_back(entry);
    }
    return entries;
}

/* Selects a grid by the rules of medium/grid_choice.h. */
murk_status choose(const std::vector<Entry> &entries, const char *name,
                   const Entry *&chosen, const Place &at)
{
    std::vector<murk_grid_entry> plain;
    for (const Entry &entry : entries) {
        plain.push_back({entry.unique.c_str(), entry.name.c_str(),
                         entry.type.c_str(), entry.is_level_set,
                         entry.is_linear});
    }
    size_t index = 0;
    const murk_status status = murk_grid_choose(
        &index, plain.data(), plain.size(), name, at.where, at.err);
    if (!status) {
        chosen = &entries[index];
    }
    return status;
}

/* Copies the transform, transposed: OpenVDB multiplies row vectors from the
 * left. Refuses a transform that is singular or not finite. */
murk_status read_transform(const openvdb::FloatGrid &grid,
                           murk_vdb_facts &facts, const Place &at)
{
    const openvdb::Mat4d m =
        grid.transform().baseMap()->getAffineMap()->getMat4();
    bool is_sane = std::isnormal(m.det());
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            facts.index_to_world[4 * row + column] = m(column, row);
            is_sane = is_sane && std::isfinite(m(column, row));
        }
    }
    return is_sane ? MURK_OK
                   : murk_fail(at.err, MURK_BAD_FILE, at.where,
                               "grid %.100s has a transform that is singular "
                               "or not finite",
                               facts.name);
}

murk_status check_box(const openvdb::FloatGrid &grid, murk_vdb_facts &facts,
                      const Place &at)
{
    const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    for (int axis = 0; axis < 3 && !box.empty(); ++axis) {
        facts.index_min[axis] = box.min()[axis];
        facts.index_max[axis] = box.max()[axis];
        if (facts.index_min[axis] <= -INDEX_MAX ||
            facts.index_max[axis] >= INDEX_MAX) {
            return murk_fail(at.err, MURK_BAD_FILE, at.where,
                             "grid %.100s reaches from voxel %lld to %lld "
                             "along %c, must be within 2^30",
                             facts.name, (long long)facts.index_min[axis],
                             (long long)facts.index_max[axis], "xyz"[axis]);
        }
    }
    return MURK_OK;
}

double volume(const openvdb::CoordBBox &box)
{
    const openvdb::Coord edge = box.dim();
    return double(edge.x()) * edge.y() * edge.z();
}

bool fits(double value, bool is_albedo)
{
    return value >= 0 && (is_albedo ? value <= 1 : std::isfinite(value));
}

/* Counts and sums the active values. Refuses a grid with an active value, or a
 * background, that is no density (a background must be 0) or no albedo. */
murk_status check_values(const openvdb::FloatGrid &grid, bool is_albedo,
                         murk_vdb_facts &facts, const Place &at)
{
    uint64_t bad = 0;
    openvdb::Coord first_bad;
    double first_value = 0;
    for (auto it = grid.tree().cbeginValueOn(); it; ++it) {
        const double value = *it;
        const uint64_t voxels = it.getVoxelCount();
        if (!fits(value, is_albedo)) {
            if (bad == 0) {
                first_bad = it.getCoord();
                first_value = value;
            }
            bad += voxels;
            continue;
        }
        const bool is_first = facts.active == 0;
        facts.minimum = is_first ? value : std::fmin(facts.minimum, value);
        facts.maximum = is_first ? value : std::fmax(facts.maximum, value);
        facts.sum += value * double(voxels);
        facts.active += voxels;
    }
    if (bad > 0) {
        const openvdb::Vec3d p = grid.indexToWorld(first_bad);
        return murk_fail(
            at.err, MURK_BAD_VALUE, at.where,
            "grid %.100s: %llu of %llu values are %s, the first "
            "is %g at voxel (%d, %d, %d), (%g, %g, %g) m; %s",
            facts.name, (unsigned long long)bad,
            (unsigned long long)(bad + facts.active),
            is_albedo ? "no share" : "negative or not finite", first_value,
            first_bad.x(), first_bad.y(), first_bad.z(), p.x(), p.y(), p.z(),
            is_albedo ? "albedo must be 0..1" : "density must be 0 or more");
    }
    const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    if (!is_albedo && facts.active > 0 && double(facts.active) < volume(box)) {
        facts.minimum = 0;
    }
    facts.background = grid.background();
    if (is_albedo ? !fits(facts.background, true)
                  : facts.background != 0) { /* NaN, too */
        return murk_fail(at.err, MURK_BAD_VALUE, at.where,
                         "grid %.100s has the value %g everywhere outside "
                         "(its background), must be %s",
                         facts.name, facts.background,
                         is_albedo ? "0..1" : "0");
    }
    return MURK_OK;
}

/* Marks the inactive values of an albedo grid: functions that read values do
 * not ask whether a voxel is active. */
void mark_inactive(openvdb::FloatGrid &grid)
{
    for (auto it = grid.tree().beginValueOff(); it; ++it) {
        it.setValue(MURK_VDB_NO_ALBEDO);
    }
    grid.tree().root().setBackground(MURK_VDB_NO_ALBEDO, false);
}

/* Sets inactive densities to 0. */
void clear_inactive(openvdb::FloatGrid &grid, murk_vdb_facts &facts)
{
    for (auto it = grid.tree().beginValueOff(); it; ++it) {
        if (*it != 0) {
            facts.cleared += it.getVoxelCount();
            it.setValue(0);
        }
    }
}

murk_status check(const openvdb::FloatGrid &grid, bool is_albedo,
                  murk_vdb_facts &facts, const Place &at)
{
    murk_status status = read_transform(grid, facts, at);
    if (!status) {
        status = check_box(grid, facts, at);
    }
    return status ? status : check_values(grid, is_albedo, facts, at);
}

murk_status deliver(openvdb::FloatGrid::Ptr grid, bool is_albedo,
                    murk_vdb_facts &facts, murk_vdb_sink take, void *context,
                    const Place &at)
{
    const murk_status status = check(*grid, is_albedo, facts, at);
    if (status) {
        return status;
    }
    if (facts.active == 0) {
        return take(context, &facts, nullptr, 0);
    }
    if (is_albedo) {
        mark_inactive(*grid);
    } else {
        clear_inactive(*grid, facts);
    }
    /* Only the tree is needed; a long name or an unusual transform is not
     * converted. */
    auto bare = openvdb::FloatGrid::create(grid->treePtr());
    nanovdb::OpenToNanoVDB<float, float> convert;
    const nanovdb::GridHandle<> handle = convert(
        *bare, nanovdb::StatsMode::BBox, nanovdb::ChecksumMode::Disable, 0);
    bare.reset();
    grid.reset(); /* releases memory before the bytes are sent */
    return take(context, &facts, handle.data(), handle.size());
}

void set_name(murk_vdb_facts &facts, const std::string &name)
{
    std::strncpy(facts.name, name.c_str(), sizeof facts.name - 1);
}

/* Converts a double grid. Values that a float cannot hold are refused, since
 * they would become infinite. */
murk_status convert(const openvdb::DoubleGrid &fine, const char *name,
                    openvdb::FloatGrid::Ptr &grid, const Place &at)
{
    const double upper = std::numeric_limits<float>::max();
    for (auto it = fine.tree().cbeginValueAll(); it; ++it) {
        if (std::isfinite(*it) && std::fabs(*it) > upper) {
            const openvdb::Coord v = it.getCoord();
            return murk_fail(at.err, MURK_BAD_VALUE, at.where,
                             "grid %.100s holds %g at voxel (%d, %d, %d), "
                             "must be at most %g, as floats hold",
                             name, *it, v.x(), v.y(), v.z(), upper);
        }
    }
    grid = std::make_shared<openvdb::FloatGrid>(fine);
    return MURK_OK;
}

/* Reads the grid as floats, whatever the precision in the file. */
murk_status read_values(openvdb::io::File &file, const char *name,
                        openvdb::FloatGrid::Ptr &grid, const Place &at)
{
    const openvdb::GridBase::Ptr any = file.readGrid(name);
    const auto fine = openvdb::gridPtrCast<openvdb::DoubleGrid>(any);
    if (fine) {
        return convert(*fine, name, grid, at);
    }
    grid = openvdb::gridPtrCast<openvdb::FloatGrid>(any);
    return grid ? MURK_OK
                : murk_fail(at.err, MURK_BAD_FILE, at.where,
                            "grid %.100s is not what its header says", name);
}

/* Opens a file and reads the selected grid; facts.name becomes the name. */
murk_status load(const char *path, const char *name,
                 openvdb::FloatGrid::Ptr &grid, murk_vdb_facts &facts,
                 const Place &at)
{
    openvdb::initialize();
    openvdb::io::File file(path);
    file.setCopyMaxBytes(0);
    file.open(
        false); /* no delayed loading, so that errors of the file occur here */
    const std::vector<Entry> entries = list_grids(file);
    const Entry *entry = nullptr;
    murk_status status = choose(entries, name, entry, at);
    if (status) {
        return status;
    }
    set_name(facts, entry->unique);
    return read_values(file, entry->unique.c_str(), grid, at);
}

murk_status read(const char *path, const char *name, bool is_albedo,
                 murk_vdb_sink take, void *context, const Place &at)
{
    openvdb::FloatGrid::Ptr grid;
    murk_vdb_facts facts = {};
    const murk_status status = load(path, name, grid, facts, at);
    return status
               ? status
               : deliver(std::move(grid), is_albedo, facts, take, context, at);
}

/* ---- two frames ---- */

/* One of two frames: the file, the grid and what its checks have found. */
struct Frame {
    const char *path;
    Place at;
    openvdb::FloatGrid::Ptr grid;
    murk_vdb_facts facts;
};

/* Fails with the difference between two frames in number i of the rows of the
 * transform: columns 0 to 2 are the edges of a voxel, column 3 is the centre of
 * voxel (0, 0, 0). */
murk_status other_transform(const Frame &a, const Frame &b, int i)
{
    const int row = i / 4, column = i % 4;
    char found[MURK_NUMBER_SIZE], wanted[MURK_NUMBER_SIZE];
    murk_number_print(found, b.facts.index_to_world[i]);
    murk_number_print(wanted, a.facts.index_to_world[i]);
    return column == 3
               ? murk_fail(b.at.err, MURK_BAD_VALUE, b.at.where,
                           "grid %.100s has voxel (0, 0, 0) at %c = %s m, "
                           "must be at %s m, as in %.200s: frames are "
                           "interpolated voxel by voxel",
                           b.facts.name, "xyz"[row], found, wanted, a.path)
               : murk_fail(b.at.err, MURK_BAD_VALUE, b.at.where,
                           "grid %.100s has voxels whose axis %c extends "
                           "%s m along %c, must be %s m, as in %.200s: "
                           "frames are interpolated voxel by voxel",
                           b.facts.name, "ijk"[column], found, "xyz"[row],
                           wanted, a.path);
}

/* Fails with the first difference if the transforms of two frames are not
 * equal. */
murk_status compare_transforms(const Frame &a, const Frame &b)
{
    for (int i = 0; i < 12; ++i) {
        if (a.facts.index_to_world[i] != b.facts.index_to_world[i]) {
            return other_transform(a, b, i);
        }
    }
    return MURK_OK;
}

/* Replaces the values a of the first tree by (1 - weight) * a + weight * b,
 * where b are the values of the second tree, which is left empty. A voxel or
 * tile is active if it is active in either tree (the default of CombineArgs).
 * The result of a value depends on two numbers alone, and not on the order in
 * which the trees are traversed. */
void interpolate(openvdb::FloatTree &first, openvdb::FloatTree &second,
                 double weight)
{
    auto mean = [weight](openvdb::CombineArgs<float> &pair) {
        pair.setResult(
            float((1 - weight) * double(pair.a()) + weight * double(pair.b())));
    };
    first.combineExtended(second, mean);
}

murk_status read_frame(Frame &frame, const char *name)
{
    murk_status status =
        load(frame.path, name, frame.grid, frame.facts, frame.at);
    if (!status) {
        status = check(*frame.grid, false, frame.facts, frame.at);
    }
    if (!status) {
        clear_inactive(*frame.grid, frame.facts);
    }
    return status;
}

murk_status read_between(Frame &a, Frame &b, const char *name, double weight,
                         murk_vdb_sink take, void *context)
{
    /* Read both grids; an exception belongs to the file that is read. */
    murk_status status = guard(a.at, [&] { return read_frame(a, name); });
    if (!status) {
        status = guard(b.at, [&] { return read_frame(b, name); });
    }
    if (!status) {
        status = compare_transforms(a, b);
    }
    if (status) {
        return status;
    }
    /* Both grids become one, which is checked and counted as any grid. */
    interpolate(a.grid->tree(), b.grid->tree(), weight);
    b.grid.reset();
    murk_vdb_facts facts = {};
    set_name(facts, a.facts.name);
    facts.cleared = a.facts.cleared;
    facts.cleared_next = b.facts.cleared;
    return deliver(std::move(a.grid), false, facts, take, context, a.at);
}

/* ---- samples ---- */

/* Makes a tree of dense samples, x fastest; zeros are left out. */
openvdb::FloatGrid::Ptr
tree_from_samples(const size_t size[3], const float *sample, const double m[12])
{
    auto grid = openvdb::FloatGrid::create(0);
    auto to = grid->getAccessor();
    const float *value = sample;
    for (size_t k = 0; k < size[2]; ++k) {
        for (size_t j = 0; j < size[1]; ++j) {
            for (size_t i = 0; i < size[0]; ++i, ++value) {
                if (*value != 0) {
                    to.setValue(openvdb::Coord(int(i), int(j), int(k)), *value);
                }
            }
        }
    }
    openvdb::Mat4d transform = openvdb::Mat4d::identity();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            transform(column, row) = m[4 * row + column];
        }
    }
    grid->setTransform(
        openvdb::math::Transform::createLinearTransform(transform));
    return grid;
}

murk_status from_samples(const size_t size[3], const float *density,
                         const double m[12], int as_tiles, murk_vdb_sink take,
                         void *context, const Place &at)
{
    const auto grid = tree_from_samples(size, density, m);
    if (as_tiles) {
        openvdb::tools::prune(grid->tree());
    }
    murk_vdb_facts facts = {};
    set_name(facts, "samples");
    return deliver(grid, false, facts, take, context, at);
}

/* Writes grids to a stream. OpenVDB's own file writer cannot write to memory,
 * and does not check whether the stream failed. */
struct Writer : openvdb::io::Archive {
    void write_to(std::ostream &stream, const openvdb::GridCPtrVec &grids)
    {
        Archive::write(stream, grids, true);
    }
};

murk_status write(const murk_vdb_field *fields, size_t n, const size_t size[3],
                  const double m[12], murk_vdb_bytes_sink take, void *context)
{
    openvdb::initialize();
    openvdb::GridCPtrVec grids;
    for (size_t i = 0; i < n; ++i) {
        const auto grid = tree_from_samples(size, fields[i].value, m);
        grid->setName(fields[i].name);
        grid->setGridClass(openvdb::GRID_FOG_VOLUME);
        grid->setCreator("murk");
        const char *const *note = fields[i].notes;
        for (; note && note[0]; note += 2) {
            grid->insertMeta(note[0], openvdb::StringMetadata(note[1]));
        }
        grids.push_back(grid);
    }
    std::stringstream stream(std::ios::in | std::ios::out | std::ios::binary);
    Writer().write_to(stream, grids);
    grids.clear();
    if (!stream) {
        throw std::bad_alloc();
    }
    const std::string bytes = stream.str();
    return take(context, bytes.data(), bytes.size());
}

murk_status read_one(const char *path, const char *name, int is_albedo,
                     murk_vdb_sink take, void *context, const char *where,
                     murk_error *err)
{
    const Place at{where, err};
    return guard(at, [&] {
        return read(path, name, is_albedo != 0, take, context, at);
    });
}

murk_status read_two(const char *const path[2], const char *name, double weight,
                     murk_vdb_sink take, void *context,
                     const char *const where[2], murk_error *err)
{
    Frame a{path[0], {where[0], err}, nullptr, {}};
    Frame b{path[1], {where[1], err}, nullptr, {}};
    return guard(
        a.at, [&] { return read_between(a, b, name, weight, take, context); });
}

murk_status make(const size_t size[3], const float *density,
                 const double index_to_world[12], int as_tiles,
                 murk_vdb_sink take, void *context, const char *where,
                 murk_error *err)
{
    const Place at{where, err};
    return guard(at, [&] {
        return from_samples(size, density, index_to_world, as_tiles, take,
                            context, at);
    });
}

murk_status write_file(const murk_vdb_field *fields, size_t n,
                       const size_t size[3], const double index_to_world[12],
                       murk_vdb_bytes_sink take, void *context,
                       const char *where, murk_error *err)
{
    const Place at{where, err};
    return guard(at, [&] {
        return write(fields, n, size, index_to_world, take, context);
    });
}

} // namespace

const murk_vdb murk_vdb_functions = {read_one, read_two, make, write_file};
