/* Writes the small grids of this folder, each with one oddity; its tests say
 * what must become of them. Not part of the build: run it by hand when a grid
 * is to be added, from this folder:
 *
 *   g++ -std=c++17 -O1 make_grids.cpp -lopenvdb -ltbb -lImath -o make_grids
 *   ./make_grids
 *
 * The format carries a random file id, so two runs differ in some bytes. */
#include <cmath>
#include <openvdb/openvdb.h>
#include <openvdb/points/PointConversion.h>

using openvdb::Coord;
using openvdb::CoordBBox;
using openvdb::FloatGrid;

static FloatGrid::Ptr fog(const char *name, float background = 0)
{
    auto grid = FloatGrid::create(background);
    grid->setName(name);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    return grid;
}

static void set(FloatGrid::Ptr grid, int i, int j, int k, float value)
{
    grid->tree().setValueOn(Coord(i, j, k), value);
}

static void write(const char *path, const openvdb::GridPtrVec &grids)
{
    openvdb::io::File(path).write(grids);
}

int main()
{
    openvdb::initialize();

    /* Tiles of 8, 128 and 4096 voxels, a leaf, negative coordinates. */
    auto tiles = fog("density");
    tiles->tree().fill(CoordBBox(Coord(-8, -8, -8), Coord(-1, -1, -1)), 3);
    tiles->tree().fill(CoordBBox(Coord(128, 0, 0), Coord(255, 127, 127)), 2);
    tiles->tree().fill(CoordBBox(Coord(4096, 0, 0), Coord(8191, 4095, 4095)),
                       1);
    for (int i = 0; i < 8; ++i) {
        set(tiles, i, 0, 0, float(i));
    }
    write("tiles.vdb", {tiles});

    /* Noise in a box whose lowest voxel is below 0 and not that of a leaf. */
    auto below = fog("density");
    for (int i = -13; i <= 10; ++i) {
        for (int j = -5; j <= 9; ++j) {
            for (int k = -21; k <= 3; ++k) {
                set(below, i, j, k, float((i * 7 + j * 13 + k * 29) & 15) / 8);
            }
        }
    }
    write("below.vdb", {below});

    /* Two voxels in an enormous box. */
    auto wide = fog("density");
    set(wide, -1000000000, -7, 5, 2);
    set(wide, 1000000000, -7, 5, 3);
    write("wide.vdb", {wide});

    auto far = fog("density");
    set(far, 0, 0, 2000000000, 1);
    write("far.vdb", {far});

    /* Anisotropic voxels, turned, moved, as half floats. */
    auto moved = fog("density");
    for (int i = 0; i < 4; ++i) {
        set(moved, i, i % 2, 0, 0.1f * float(i));
    }
    auto map = openvdb::math::Transform::createLinearTransform();
    map->preScale(openvdb::Vec3d(0.5, 2, 4));
    map->postRotate(M_PI / 2, openvdb::math::Z_AXIS);
    map->postTranslate(openvdb::Vec3d(10, 20, 30));
    moved->setTransform(map);
    moved->setSaveFloatAsHalf(true);
    write("moved.vdb", {moved});

    /* Values that are no density. */
    auto negative = fog("density");
    set(negative, 1, 1, 1, 1);
    set(negative, 2, 1, 1, -0.5);
    set(negative, 3, 1, 1, -0.25);
    write("negative.vdb", {negative});
    auto nan = fog("density");
    set(nan, 1, 1, 1, 1);
    set(nan, 1, 2, 1, NAN);
    write("nan.vdb", {nan});
    auto infinite = fog("density");
    infinite->tree().fill(CoordBBox(Coord(0), Coord(7)), INFINITY);
    write("infinite.vdb", {infinite});
    auto background = fog("density", 0.25);
    set(background, 1, 1, 1, 1);
    write("background.vdb", {background});
    auto nan_background = fog("density", NAN);
    set(nan_background, 1, 1, 1, 1);
    write("nan_background.vdb", {nan_background});

    /* A voxel and a tile that hold values but are not active. */
    auto inactive = fog("density");
    set(inactive, 0, 0, 0, 1);
    inactive->tree().setValueOff(Coord(1, 0, 0), 5);
    inactive->tree().fill(CoordBBox(Coord(8, 0, 0), Coord(15, 7, 7)), 5, false);
    write("inactive.vdb", {inactive});

    /* Double precision; once with a value that no float holds. */
    auto fine = openvdb::DoubleGrid::create(0);
    fine->setName("density");
    fine->tree().setValueOn(Coord(1, 2, 3), 0.1);
    fine->tree().fill(CoordBBox(Coord(8, 0, 0), Coord(15, 7, 7)), 1e-300);
    openvdb::io::File("fine.vdb").write({fine});
    fine->tree().setValueOn(Coord(2, 2, 3), 1e39);
    openvdb::io::File("fine_overflow.vdb").write({fine});

    /* Albedos: two voxels apart from each other, 0.5 elsewhere; a value and a
     * background that are no shares. */
    auto albedo = fog("albedo", 0.5);
    set(albedo, 0, 0, 0, 0.25);
    set(albedo, 1, 0, 0, 0.75);
    set(albedo, 3, 0, 0, 0);
    albedo->tree().setValueOff(Coord(0, 1, 0), 7);
    write("albedo.vdb", {albedo});
    set(albedo, 2, 0, 0, 1.5);
    write("albedo_above.vdb", {albedo});
    auto dark = fog("albedo", -1);
    set(dark, 0, 0, 0, 1);
    write("albedo_background.vdb", {dark});
    /* A root tile of 4096 voxels along an edge that is black, a voxel beside.
     */
    auto black = fog("albedo", 0.5);
    black->tree().fill(CoordBBox(Coord(0), Coord(4095)), 0, true);
    set(black, -1, 0, 0, 0.25);
    write("albedo_tile.vdb", {black});

    auto frustum = fog("density");
    set(frustum, 1, 1, 1, 1);
    frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
        openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(10)), 0.5, 4, 1));
    write("frustum.vdb", {frustum});

    auto flat = fog("density");
    set(flat, 1, 1, 1, 1);
    auto huge = openvdb::math::Transform::createLinearTransform();
    huge->preScale(openvdb::Vec3d(1e150, 1e150, 1e150));
    flat->setTransform(huge);
    write("overflow.vdb", {flat});

    /* Names: two of one name, one without, others that are not floats. */
    auto first = fog("smoke"), second = fog("smoke"), nameless = fog("");
    set(first, 0, 0, 0, 1);
    set(second, 0, 0, 0, 2);
    set(nameless, 0, 0, 0, 3);
    auto doubles = openvdb::DoubleGrid::create(0);
    doubles->setName("fine");
    auto mask = openvdb::BoolGrid::create(false);
    mask->setName("mask");
    write("names.vdb", {first, second, nameless, doubles, mask});
    write("nameless.vdb", {nameless, mask});
    write("mask.vdb", {mask});
    write("none.vdb", {});

    const std::vector<openvdb::Vec3d> positions = {{0, 0, 0}, {1, 1, 1}};
    auto points =
        openvdb::points::createPointDataGrid<openvdb::points::NullCodec,
                                             openvdb::points::PointDataGrid>(
            positions, *openvdb::math::Transform::createLinearTransform(1));
    points->setName("points");
    write("points.vdb", {points});
}
