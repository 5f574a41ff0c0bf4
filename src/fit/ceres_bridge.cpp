// Minimises with the Levenberg-Marquardt method of Ceres, and factorises
// matrices with Eigen, behind a C interface (fit/ceres_bridge.h): a module.
// Ceres sees each row as a residual block of its own, so that the loss acts on
// each row, while all rows are evaluated by one call.
extern "C" {
#include "fit/ceres_bridge.h"
}

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <deque>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace
{

using Matrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The number of invalid steps in succession at which Ceres gives up. Ceres
// calls a step invalid if the linear solver fails or if the step would not
// lower the linearised cost. After invalid step number k the radius of the
// trust region is divided by 2^k or more, so that 16 attempts cover every
// useful length.
const int INVALID_STEPS_MAX = 16;

// A step ends the search if the norm of the step is at most
// SHORT_STEP * (norm of x + SHORT_STEP).
const double SHORT_STEP = 1e-12;

// All rows at one parameter vector: evaluated once, then read row by row.
class AllRows final : public ceres::EvaluationCallback
{
  public:
    AllRows(double *x, const bool *is_held, const murk_least_squares &problem)
        : problem_(problem)
    {
        for (size_t j = 0; j < problem.n; ++j) {
            if (!is_held[j]) {
                free_.push_back(j);
                block_.push_back(x[j]);
            }
        }
        x_.assign(x, x + problem.n);
        residual_.resize(problem.rows);
        jacobian_.resize(problem.rows * problem.n);
    }

    void PrepareForEvaluation(bool with_jacobian, bool) override
    {
        fill_x();
        is_good_ =
            problem_.residuals(problem_.context, x_.data(), residual_.data(),
                               with_jacobian ? jacobian_.data() : nullptr);
    }

    // The free parameters, the only ones that Ceres sees.
    std::vector<double> &block()
    {
        return block_;
    }

    const std::vector<size_t> &free() const
    {
        return free_;
    }

    // All parameters, with the free ones from the block.
    const double *fill_x()
    {
        for (size_t i = 0; i < free_.size(); ++i) {
            x_[free_[i]] = block_[i];
        }
        return x_.data();
    }

    bool read(size_t row, double *residual, double *slope) const
    {
        if (!is_good_) {
            return false;
        }
        *residual = residual_[row];
        if (slope) {
            for (size_t i = 0; i < free_.size(); ++i) {
                slope[i] = jacobian_[row * problem_.n + free_[i]];
            }
        }
        return true;
    }

  private:
    const murk_least_squares &problem_;
    std::vector<size_t> free_;
    std::vector<double> block_, x_, residual_, jacobian_;
    bool is_good_ = false;
};

// One residual block for one row, so that the loss acts on each row.
class Row final : public ceres::CostFunction
{
  public:
    Row(const AllRows &all, size_t row) : all_(all), row_(row)
    {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(
            static_cast<int>(all.free().size()));
    }

    bool Evaluate(double const *const *, double *residual,
                  double **jacobian) const override
    {
        return all_.read(row_, residual, jacobian ? jacobian[0] : nullptr);
    }

  private:
    const AllRows &all_;
    size_t row_;
};

class Watch final : public ceres::IterationCallback
{
  public:
    Watch(AllRows &all, const murk_least_squares &problem)
        : all_(all), problem_(problem)
    {
    }

    ceres::CallbackReturnType
    operator()(const ceres::IterationSummary &summary) override
    {
        const murk_least_squares_step step{summary.iteration,
                                           summary.step_is_successful ||
                                               summary.iteration == 0,
                                           summary.cost, all_.fill_x()};
        return problem_.watch(problem_.context, &step)
                   ? ceres::SOLVER_CONTINUE
                   : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    }

  private:
    AllRows &all_;
    const murk_least_squares &problem_;
};

// Turns off all messages of Ceres and glog except fatal ones; they would go to
// stderr. Once in a process: the level is a global variable that must not
// change while other threads solve.
void silence()
{
    static const bool is_silent = [] {
        FLAGS_minloglevel = google::GLOG_FATAL;
        return true;
    }();
    (void)is_silent;
}

std::unique_ptr<ceres::LossFunction> make_loss(const murk_least_squares &p)
{
    switch (p.loss) {
    case MURK_LOSS_FUNCTION_HUBER:
        return std::make_unique<ceres::HuberLoss>(p.loss_width);
    case MURK_LOSS_FUNCTION_CAUCHY:
        return std::make_unique<ceres::CauchyLoss>(p.loss_width);
    case MURK_LOSS_FUNCTION_NONE:
        break;
    }
    return nullptr;
}

bool starts(const std::string &text, const char *with)
{
    return text.rfind(with, 0) == 0;
}

murk_ceres_end end_of(const ceres::Solver::Summary &summary)
{
    switch (summary.termination_type) {
    case ceres::CONVERGENCE:
        return starts(summary.message, "Function")    ? MURK_CERES_LEVEL
               : starts(summary.message, "Parameter") ? MURK_CERES_SHORT_STEP
               : starts(summary.message, "Gradient")  ? MURK_CERES_FLAT
                                                      : MURK_CERES_FAILED;
    case ceres::NO_CONVERGENCE:
        return MURK_CERES_ITERATIONS;
    case ceres::USER_SUCCESS:
        return MURK_CERES_STOPPED;
    default:
        return MURK_CERES_FAILED;
    }
}

ceres::Solver::Options options_for(const murk_least_squares &p, Watch &watch)
{
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = p.iterations_max;
    options.max_num_consecutive_invalid_steps = INVALID_STEPS_MAX;
    options.function_tolerance = p.tolerance;
    options.parameter_tolerance = SHORT_STEP;
    // The gradient tolerance is absolute: only 0 is meaningful for every unit.
    options.gradient_tolerance = 0;
    options.update_state_every_iteration = true; /* for the callback `watch` */
    options.callbacks.push_back(&watch);
    return options;
}

void minimise(murk_ceres_found *found, double *x, const bool *is_held,
              const murk_least_squares &p)
{
    silence();
    AllRows all(x, is_held, p);
    Watch watch(all, p);
    const std::unique_ptr<ceres::LossFunction> loss = make_loss(p);
    std::deque<Row> rows; /* a deque, because Ceres keeps the addresses */

    // One residual block for each row; this function owns the rows, the loss
    // and the callback, not the problem of Ceres.
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.evaluation_callback = &all;
    ceres::Problem problem(ownership);
    double *block = all.block().data();
    for (size_t i = 0; i < p.rows; ++i) {
        rows.emplace_back(all, i);
        problem.AddResidualBlock(&rows.back(), loss.get(), block);
    }
    ceres::Solver::Summary summary;
    ceres::Solve(options_for(p, watch), &problem, &summary);

    // Translate the outcome.
    found->end = end_of(summary);
    found->iterations =
        std::max(0, static_cast<int>(summary.iterations.size()) - 1);
    std::snprintf(found->message, sizeof found->message, "%s",
                  summary.message.c_str());
    for (char *c = found->message; *c; ++c) {
        *c = *c == '\n' ? ' ' : *c;
    }
    if (summary.IsSolutionUsable()) {
        std::memcpy(x, all.fill_x(), p.n * sizeof *x);
    }
}

template <typename Work> murk_status guard(murk_error *err, Work work)
{
    try {
        work();
        return MURK_OK;
    } catch (const std::bad_alloc &) {
        return murk_no_memory(err, "fit", "for a fit");
    } catch (const std::exception &e) {
        return murk_fail(err, MURK_RUN_FAILED, "fit", "%s", e.what());
    } catch (...) {
        return murk_fail(err, MURK_RUN_FAILED, "fit", "the solver failed");
    }
}

murk_status minimise_once(murk_ceres_found *found, double *x,
                          const bool *is_held,
                          const murk_least_squares *problem, murk_error *err)
{
    return guard(err, [&] { minimise(found, x, is_held, *problem); });
}

murk_status factorise(double *a, size_t n, bool *is_positive, murk_error *err)
{
    return guard(err, [&] {
        const auto size = static_cast<Eigen::Index>(n);
        Eigen::Map<Matrix> lower(a, size, size);
        const Eigen::LLT<Eigen::Ref<Matrix>> factor(lower);
        *is_positive = factor.info() == Eigen::Success;
    });
}

murk_status decompose(double *singular, double *direction, const double *a,
                      size_t rows, size_t n, murk_error *err)
{
    return guard(err, [&] {
        const auto columns = static_cast<Eigen::Index>(n);
        const Eigen::Map<const Matrix> matrix(
            a, static_cast<Eigen::Index>(rows), columns);
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix,
                                                    Eigen::ComputeFullV);
        const auto &values = svd.singularValues();
        for (Eigen::Index k = 0; k < columns; ++k) {
            singular[k] = k < values.size() ? values[k] : 0;
            const auto v = svd.matrixV().col(k);
            Eigen::Index largest = 0;
            v.cwiseAbs().maxCoeff(&largest);
            const double sign = v[largest] < 0 ? -1 : 1;
            for (Eigen::Index j = 0; j < columns; ++j) {
                direction[k * columns + j] = sign * v[j];
            }
        }
    });
}

} // namespace

const murk_ceres murk_ceres_functions = {minimise_once, factorise, decompose};
