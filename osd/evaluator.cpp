// SPDX-License-Identifier: Apache-2.0
// The driver that every backend shares: checks, then one table after another.
#include <solidsubdiv/osd/evaluator.h>

#include <functional>
#include <string>

namespace SolidSubdiv::Osd {

namespace {

template <class View>
void RequireView(const View& view, Offset n, const char* name) {
    const BufferDescriptor& d = view.descriptor;
    if (d.length < 1 || d.stride < d.length || d.offset < 0) {
        throw InvalidInput(std::string(name) + ": offset " + std::to_string(d.offset) + ", length " +
                           std::to_string(d.length) + ", stride " + std::to_string(d.stride) +
                           "; length must be at least 1, stride at least length");
    }
    if (!view.Holds(n)) {
        throw InvalidInput(std::string(name) + " holds " + std::to_string(view.size) + " numbers; " +
                           std::to_string(n) + " elements of length " + std::to_string(d.length) + " from offset " +
                           std::to_string(d.offset) + " with stride " + std::to_string(d.stride) + " need " +
                           std::to_string(static_cast<unsigned long long>(d.offset) +
                                          static_cast<unsigned long long>((n - 1) * d.stride + d.length)));
    }
}

/// Refuses views whose elements share memory; interleaved elements of one array are fine.
template <class Real>
void RequireApart(const BufferView<const Real>& source, Offset n_source, const BufferView<Real>& destination,
                  Offset n_destination) {
    if (n_source == 0 || n_destination == 0) return;
    const auto last = [](const auto& view, Offset n) { return view.Element(n - 1) + view.descriptor.length; };
    const std::less<const Real*> before;
    const Real *s0 = source.Element(0), *s1 = last(source, n_source);
    const Real *d0 = destination.Element(0), *d1 = last(destination, n_destination);
    if (!before(s0, d1) || !before(d0, s1)) return;
    // Ranges overlap: harmless only where both step alike and their elements never meet within a step.
    const int stride = source.descriptor.stride;
    if (stride == destination.descriptor.stride) {
        const Offset shift = ((d0 - s0) % stride + stride) % stride;
        if (shift >= source.descriptor.length && shift + destination.descriptor.length <= stride) return;
    }
    throw InvalidInput("source and destination overlap");
}

template <class Real>
void RequireFit(const BufferView<const Real>& source, Offset n_source, const BufferView<Real>& destination,
                Offset n_destination) {
    RequireView(source, n_source, "the source");
    RequireView(destination, n_destination, "the destination");
    if (source.descriptor.length != destination.descriptor.length) {
        throw InvalidInput("the source has " + std::to_string(source.descriptor.length) +
                           " values an element, the destination " + std::to_string(destination.descriptor.length));
    }
    RequireApart(source, n_source, destination, n_destination);
}

template <class Real>
BufferView<const Real> AsSource(const BufferView<Real>& view) {
    return {std::span<const Real>(view.data, static_cast<std::size_t>(view.size)), view.descriptor};
}

}  // namespace

template <class Real>
Index EvaluatorReal<Real>::n_refined_vertices() const {
    return table_.n_levels() == 0 ? table_.n_control_vertices() : table_.level(table_.n_levels()).n_rows();
}

template <class Real>
Offset EvaluatorReal<Real>::n_vertices_of_all_levels() const {
    Offset n = 0;
    for (int i = 1; i <= table_.n_levels(); ++i) n += table_.level(i).n_rows();
    return n;
}

template <class Real>
void EvaluatorReal<Real>::Apply(int level, const BufferView<const Real>& source, const BufferView<Real>& destination) {
    const auto& rows = table_.level(level);
    backend_.template eval<Real>()(rows, source, destination, 0, rows.n_rows());
}

template <class Real>
void EvaluatorReal<Real>::Evaluate(const BufferView<const Real>& source, const BufferView<Real>& destination) {
    RequireFit(source, table_.n_control_vertices(), destination, n_refined_vertices());
    const int n_levels = table_.n_levels(), length = source.descriptor.length;
    if (n_levels == 0) {  // nothing refined: a copy
        for (Index v = 0; v < table_.n_control_vertices(); ++v) {
            for (int c = 0; c < length; ++c) destination.Element(v)[c] = source.Element(v)[c];
        }
        return;
    }
    BufferView<const Real> from = source;
    for (int i = 1; i < n_levels; ++i) {
        Array<Real>& scratch = scratch_[i % 2];
        scratch.resize(static_cast<std::size_t>(table_.level(i).n_rows()) * static_cast<std::size_t>(length));
        const BufferView<Real> to(std::span<Real>(scratch), length);
        Apply(i, from, to);
        from = AsSource(to);
    }
    Apply(n_levels, from, destination);
}

template <class Real>
void EvaluatorReal<Real>::EvaluateAllLevels(const BufferView<const Real>& source, const BufferView<Real>& destination) {
    RequireFit(source, table_.n_control_vertices(), destination, n_vertices_of_all_levels());
    BufferView<const Real> from = source;
    BufferView<Real> to = destination;
    for (int i = 1; i <= table_.n_levels(); ++i) {
        Apply(i, from, to);
        from = AsSource(to);
        to = to.From(table_.level(i).n_rows());
    }
}

template <class Real>
void EvaluatorReal<Real>::EvaluateRange(int level, const BufferView<const Real>& source,
                                        const BufferView<Real>& destination, Index begin, Index end) {
    if (level < 1 || level > table_.n_levels() || begin < 0 || begin > end || end > table_.level(level).n_rows()) {
        throw InvalidInput("rows " + std::to_string(begin) + " to " + std::to_string(end) + " of level " +
                           std::to_string(level) + " are not all there");
    }
    RequireFit(source, table_.level(level).n_sources, destination, begin < end ? end : 0);
    backend_.template eval<Real>()(table_.level(level), source, destination, begin, end);
}

template class EvaluatorReal<double>;
template class EvaluatorReal<float>;

}  // namespace SolidSubdiv::Osd
