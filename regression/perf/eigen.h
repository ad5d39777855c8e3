// SPDX-License-Identifier: Apache-2.0
// Eigen's sparse times dense product at its fastest for three columns: row-major both, three known when compiled.
#pragma once

#if SOLIDSUBDIV_HAS_EIGEN

#include <solidsubdiv/sdc/types.h>

#include <memory>

namespace SolidSubdiv::Perf {

class EigenRows {
  public:
    EigenRows(int n_rows, int n_columns, const Offset* offsets, const Index* indices, const float* weights);
    ~EigenRows();

    void Evaluate(const float* source, float* destination, int n_threads) const;
    /// 1 where it was compiled without OpenMP.
    static int MaxThreads();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Perf

#endif
