// SPDX-License-Identifier: Apache-2.0
// The only source that includes Eigen.
#include "perf/eigen.h"

#if SOLIDSUBDIV_HAS_EIGEN

#include <Eigen/SparseCore>

#include "perf/machine.h"

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace SolidSubdiv::Perf {

struct EigenRows::State {
    Eigen::SparseMatrix<float, Eigen::RowMajor, int> matrix;
};

EigenRows::EigenRows(int n_rows, int n_columns, const Offset* offsets, const Index* indices, const float* weights)
    : state_(std::make_unique<State>()) {
    std::vector<Eigen::Triplet<float, int>> triplets;
    for (int row = 0; row < n_rows; ++row) {
        for (Offset k = offsets[row]; k < offsets[row + 1]; ++k) triplets.emplace_back(row, indices[k], weights[k]);
    }
    state_->matrix.resize(n_rows, n_columns);
    state_->matrix.setFromTriplets(triplets.begin(), triplets.end());
}
EigenRows::~EigenRows() = default;

int EigenRows::MaxThreads() {
#if defined(_OPENMP)
    return ProcessorCount();
#else
    return 1;
#endif
}

void EigenRows::Evaluate(const float* source, float* destination, int n_threads) const {
    using Points = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const Eigen::Map<const Points> from(source, state_->matrix.cols(), 3);
    Eigen::Map<Points> to(destination, state_->matrix.rows(), 3);
#if defined(_OPENMP)
    static bool is_pinned = false;
    if (n_threads > 1 && !is_pinned) {
        is_pinned = true;
#pragma omp parallel num_threads(n_threads)
        PinThisThread(omp_get_thread_num());
    }
#endif
    Eigen::setNbThreads(n_threads);
    to.noalias() = state_->matrix * from;
}

}  // namespace SolidSubdiv::Perf

#endif
