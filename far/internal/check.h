// SPDX-License-Identifier: Apache-2.0
// Checks of a caller's mesh, shared by Validate and TopologyRefiner::Create.
#pragma once

#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>
#include <solidsubdiv/vtr/base_level.h>

namespace SolidSubdiv::Far::Internal {

/// Collects defects, at most a given number of each code.
class DefectList {
  public:
    explicit DefectList(Index max_per_code) : max_per_code_(max_per_code) {}
    void Add(DefectCode code, Offset element, double measure, std::string text);
    std::vector<Defect> TakeFatalFirst();
    bool has_fatal() const { return has_fatal_; }
    /// Whether one more of this code would be kept: a costly text need not be made otherwise.
    bool HasRoom(DefectCode code) const { return counts_[static_cast<std::size_t>(code)] < max_per_code_; }

  private:
    std::vector<Defect> defects_;
    std::vector<Index> counts_ = std::vector<Index>(16, 0);
    Index max_per_code_;
    bool has_fatal_ = false;
};

/// Array lengths, index ranges, repeated vertices, duplicate cells: what must hold before a level is built.
void CheckElements(const TopologyDescriptor& descriptor, DefectList& defects);

/// What building level 0 found, in words. An edge that coincides with another one is no defect if it is a crease.
void AddFindings(const TopologyDescriptor& descriptor, const Vtr::Level& level, const Vtr::BaseFindings& findings,
                 DefectList& defects);

/// Kinds of elements that the tet/oct split does not take, as a text "3 hexahedra, 1 wedge", or empty.
std::string KindsBeyondTetOct(const TopologyDescriptor& descriptor);

Vtr::BaseElements ElementsOf(const TopologyDescriptor& descriptor);

}  // namespace SolidSubdiv::Far::Internal
