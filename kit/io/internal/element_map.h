// SPDX-License-Identifier: Apache-2.0
// Finds an edge or a single vertex among those already there, by its vertices.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace SolidSubdiv::Io::Internal {

/// From an element of one or two vertices, an edge in either direction, to a number.
class ElementMap {
  public:
    /// The element's number; it becomes `number` if the element is new.
    template <class Vertex>
    std::int64_t FindOrAdd(std::span<const Vertex> vertices, std::int64_t number) {
        const auto a = static_cast<std::int64_t>(vertices.front());
        const auto b = static_cast<std::int64_t>(vertices.back());
        // A vertex is no edge from it to itself, which a file may have too.
        const Key key = vertices.size() == 1 ? Key{a, -1} : Key{std::max(a, b), std::min(a, b)};
        return numbers_.try_emplace(key, number).first->second;
    }

  private:
    struct Key {
        std::int64_t high, low;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t h = static_cast<std::uint64_t>(key.high) * 0x9e3779b97f4a7c15u;
            h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(key.low)) * 0x9e3779b97f4a7c15u;
            return static_cast<std::size_t>(h ^ (h >> 32));
        }
    };

    std::unordered_map<Key, std::int64_t, Hash> numbers_;
};

}  // namespace SolidSubdiv::Io::Internal
