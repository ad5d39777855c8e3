// SPDX-License-Identifier: Apache-2.0
// Evaluates a stencil table on data at the control vertices, as often as the data changes.
//
//     Osd::Evaluator eval(stencils, Osd::Backend::Best());
//     std::vector<double> refined(3 * eval.n_refined_vertices());
//     eval.Evaluate(mesh.positions, refined);
//
// An evaluator owns the scratch that a cascade needs; the table must outlive it. It is not for use by two threads at
// once (make one each: they share the table).
#pragma once

#include <span>

#include <solidsubdiv/osd/backend.h>

namespace SolidSubdiv::Osd {

template <class Real>
class EvaluatorReal {
  public:
    EvaluatorReal(const Far::StencilTableReal<Real>& table, const Backend& backend)
        : table_(table), backend_(backend) {}
    EvaluatorReal(Far::StencilTableReal<Real>&& table, const Backend& backend) = delete;  // it would be gone at once

    const Backend& backend() const { return backend_; }
    /// Rows of the last level (or of the composite table).
    Index n_refined_vertices() const;
    /// Rows of all levels together.
    Offset n_vertices_of_all_levels() const;

    /// Values of the last level. Source: (control vertices, length), destination: (n_refined_vertices, length).
    /// @throws InvalidInput where a view is too small, lengths differ, or source and destination overlap (elements of
    /// one array that lie interleaved with one stride do not)
    void Evaluate(const BufferView<const Real>& source, const BufferView<Real>& destination);
    /// Packed rows of `width`.
    void Evaluate(std::span<const Real> source, std::span<Real> destination, int width = 3) {
        Evaluate(BufferView<const Real>(source, width), BufferView<Real>(destination, width));
    }

    /// Values of all levels, level 1 first, one after another: (n_vertices_of_all_levels, length). @throws as Evaluate
    void EvaluateAllLevels(const BufferView<const Real>& source, const BufferView<Real>& destination);

    /// Rows [begin, end) of one level from the values of the level before: row i goes to element i of the destination,
    /// which needs to hold `end` elements; others are not touched.
    /// @throws InvalidInput as Evaluate, and where level or rows are not there
    void EvaluateRange(int level, const BufferView<const Real>& source, const BufferView<Real>& destination,
                       Index begin, Index end);

  private:
    void Apply(int level, const BufferView<const Real>& source, const BufferView<Real>& destination);

    const Far::StencilTableReal<Real>& table_;
    const Backend& backend_;
    Array<Real> scratch_[2];  // of levels between, by turns
};

using Evaluator = EvaluatorReal<double>;
template <class Real>
EvaluatorReal(const Far::StencilTableReal<Real>&, const Backend&) -> EvaluatorReal<Real>;

extern template class EvaluatorReal<double>;
extern template class EvaluatorReal<float>;

}  // namespace SolidSubdiv::Osd
