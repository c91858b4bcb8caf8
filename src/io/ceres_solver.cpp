#include "io/ceres_solver.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <ceres/tiny_solver.h>

namespace nacre {
namespace {

class Differences {
public:
    using Scalar = double;
    // NOLINTBEGIN(readability-identifier-naming): Ceres requires these names.
    enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

    explicit Differences(const LeastSquares& problem)
        : problem_(problem),
          moved_(static_cast<std::size_t>(problem.parameters)),
          ahead_(static_cast<std::size_t>(problem.residuals)) {}

    int NumResiduals() const { return problem_.residuals; }
    int NumParameters() const { return problem_.parameters; }
    // NOLINTEND(readability-identifier-naming)

    // The Jacobian's columns are parameters.
    bool operator()(const double* parameters, double* residuals, double* jacobian) const {
        constexpr double step = 1e-6;
        const auto count = static_cast<std::size_t>(problem_.residuals);
        moved_.assign(parameters, parameters + problem_.parameters);
        problem_.evaluate(moved_, {residuals, count});
        if (jacobian == nullptr) return true;
        for (std::size_t i = 0; i < moved_.size(); ++i) {
            moved_[i] = parameters[i] + step;
            problem_.evaluate(moved_, ahead_);
            moved_[i] = parameters[i];
            for (std::size_t row = 0; row < count; ++row)
                jacobian[i * count + row] = (ahead_[row] - residuals[row]) / step;
        }
        return true;
    }

private:
    const LeastSquares& problem_;
    mutable std::vector<double> moved_;
    mutable std::vector<double> ahead_;
};

}  // namespace

LeastSquaresSolver least_squares_solver() {
    return [](const LeastSquares& problem, std::span<double> parameters, int most_steps) {
        const Differences differences(problem);
        ceres::TinySolver<Differences> solver;
        solver.options.max_num_iterations = most_steps;
        solver.options.cost_threshold = 1e-10;
        solver.options.function_tolerance = 1e-9;
        Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters.data(), problem.parameters);
        solver.Solve(differences, &x);
        for (int i = 0; i < problem.parameters; ++i) parameters[static_cast<std::size_t>(i)] = x[i];
    };
}

}  // namespace nacre
