// SPDX-License-Identifier: Apache-2.0
// Views of values at vertices: where they lie in an array that may hold other things too.
#pragma once

#include <span>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Osd {

/// Element i's values are data[offset + i * stride + c], c in [0, length). What lies between elements belongs to
/// others: it is neither read nor written.
struct BufferDescriptor {
    Offset offset = 0;  ///< >= 0
    int length = 3;     ///< values an element, >= 1
    int stride = 3;     ///< from one element to the next, >= length
};

/// Whose memory it is.
enum class MemorySpace { Host };

template <class Real>
struct BufferView {
    Real* data = nullptr;
    Offset size = 0;  ///< numbers that data holds: nothing beyond is touched
    BufferDescriptor descriptor{};
    MemorySpace space = MemorySpace::Host;

    BufferView() = default;
    BufferView(std::span<Real> values, BufferDescriptor d)
        : data(values.data()), size(static_cast<Offset>(values.size())), descriptor(d) {}
    /// Tightly packed rows of `width`.
    BufferView(std::span<Real> values, int width) : BufferView(values, BufferDescriptor{0, width, width}) {}

    Real* Element(Offset i) const { return data + descriptor.offset + i * descriptor.stride; }

    /// The same values from element `first` on.
    BufferView From(Offset first) const {
        BufferView view = *this;
        view.descriptor.offset += first * descriptor.stride;
        return view;
    }

    /// Whether n elements fit the array. @pre descriptor.stride >= 1
    bool Holds(Offset n) const {
        if (n == 0) return true;
        if (descriptor.offset < 0 || descriptor.offset > size) return false;
        const Offset room = size - descriptor.offset - descriptor.length;  // for steps from the first to the last one
        return room >= 0 && n - 1 <= room / descriptor.stride;
    }
};

}  // namespace SolidSubdiv::Osd
