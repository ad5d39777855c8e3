// SPDX-License-Identifier: Apache-2.0
// The doors of the house: which room and which third-party library a room may include. See docs/architecture.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "house/source_tree.h"
#include "temporary_folder.h"

namespace SolidSubdiv::House {
namespace {

using Names = std::set<std::string>;

struct Doors {
    Names rooms;                  ///< what it may include, together with what those may include
    Names libraries = {};         ///< third-party headers (their beginning) that its sources may include
    Names public_libraries = {};  ///< of these, what its public headers may show
};

const std::map<std::string, Doors>& HousePlan() {
    static const std::map<std::string, Doors> plan = {
        {"sdc", {{}, {"sys/mman.h"}}},  // huge pages; and oneTBB in parallel.cpp, see below
        {"vtr", {{"sdc"}}},
        {"far", {{"vtr", "sdc"}, {"unistd.h"}}},  // how much memory the machine has
        {"osd", {{"far"}, {"immintrin.h"}}},
        {"kit/geometry", {{"osd", "far"}, {"embree3/"}}},
        {"kit/io", {{"kit/geometry", "far"}, {"pugixml.hpp", "zlib.h", "unistd.h"}}},
        {"kit/picture", {{"kit/geometry", "kit/io"}, {"embree3/", "png.h"}}},
        {"kit/analysis", {{"kit/geometry", "far"}, {"Eigen/"}, {"Eigen/"}}},
        {"apps/voxel", {{"kit/geometry", "osd", "far"}, {"openvdb/"}}},
        {"apps/deform", {{"kit/geometry", "osd", "far"}, {"Eigen/"}}},
        {"apps/dynamics", {{"kit/geometry", "osd", "far"}, {"Eigen/", "ceres/", "itk"}}},
        {"apps/fit",
         {{"apps/deform", "apps/voxel", "kit/geometry", "osd", "far"}, {"Eigen/", "ceres/", "glog/", "OpenMesh/"}}},
        {"apps/cli",
         {{"sdc", "vtr", "far", "osd", "kit/geometry", "kit/io", "kit/picture", "kit/analysis", "apps/voxel",
           "apps/deform", "apps/dynamics", "apps/fit"},
          {"CLI/", "nlohmann/", "unistd.h", "sys/"},
          {"CLI/", "nlohmann/"}}},  // a program: nobody includes its headers
    };
    return plan;
}

/// The rooms that a room may include, followed through their own doors.
Names ReachableRooms(const std::string& room) {
    Names reachable;
    for (const std::string& next : HousePlan().at(room).rooms) {
        reachable.insert(next);
        reachable.merge(ReachableRooms(next));
    }
    return reachable;
}

/// The room that a path (without solidsubdiv/) lies in, or an empty name.
std::string RoomOf(const std::string& path) {
    for (const auto& [room, doors] : HousePlan()) {
        if (path.starts_with(room + "/")) return room;
    }
    return {};
}

bool BeginsWithOneOf(const std::string& text, const Names& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const auto& b) { return text.starts_with(b); });
}

/// What is wrong with `include` in `file` of `room`, or an empty text.
std::string Trespass(const SourceFile& file, const std::string& room, const std::string& include, bool is_quoted) {
    if (is_quoted) return "headers of rooms are included as <solidsubdiv/ROOM/FILE>";
    const bool is_internal = file.path.find("/internal/") != std::string::npos;
    const bool is_public = file.path.ends_with(".h") && !is_internal;
    if (include.starts_with("solidsubdiv/")) {
        const std::string path = include.substr(12);
        const std::string other = RoomOf(path);
        if (other.empty()) return "there is no such room";
        if (other != room && !ReachableRooms(room).contains(other)) return "no door from " + room + " to " + other;
        const bool wants_internal = path.find("/internal/") != std::string::npos;
        if (wants_internal && other != room) return "internal to " + other;
        if (wants_internal && is_public) return "a public header shows an internal one, which is not installed";
        return {};
    }
    const bool is_standard = include.find_first_of("./") == std::string::npos;
    if (is_standard) return {};
    if (file.path == "sdc/parallel.cpp" && include.starts_with("tbb/")) return {};
    const Doors& doors = HousePlan().at(room);
    if (!BeginsWithOneOf(include, doors.libraries)) return "not a library of " + room;
    if (is_public && !BeginsWithOneOf(include, doors.public_libraries)) return "a public header shows a library";
    return {};
}

/// A room that a validator's oracle reaches through its includes, or an empty name. Oracles must know nothing of ours.
std::string RoomKnownTo(const SourceFile& oracle, const std::vector<SourceFile>& tree, Names& seen) {
    for (const auto& [include, is_quoted] : oracle.Includes()) {
        if (include.starts_with("solidsubdiv/")) return include;
        for (const SourceFile& file : tree) {
            const bool is_it = is_quoted && file.path == "validation/" + include;
            if (!is_it || !seen.insert(include).second) continue;
            const std::string known = RoomKnownTo(file, tree, seen);
            if (!known.empty()) return known;
        }
    }
    return {};
}

/// One line for each include that the plan does not allow.
std::vector<std::string> Trespasses(const std::vector<SourceFile>& tree) {
    std::vector<std::string> found;
    for (const SourceFile& file : tree) {
        if (!file.IsCpp()) continue;
        const std::string room = RoomOf(file.path);
        if (!room.empty()) {
            for (const auto& [include, is_quoted] : file.Includes()) {
                const std::string wrong = Trespass(file, room, include, is_quoted);
                if (!wrong.empty()) found.push_back(file.path + " includes " + include + ": " + wrong);
            }
        } else if (file.path.starts_with("kit/") || file.path.starts_with("apps/")) {
            found.push_back(file.path + ": in no room of the plan");
        } else if (file.path.starts_with("validation/") && file.path.find("oracle") != std::string::npos) {
            Names seen;
            const std::string known = RoomKnownTo(file, tree, seen);
            if (!known.empty()) found.push_back(file.path + " knows " + known + ": an oracle must not know our rooms");
        }
    }
    return found;
}

TEST(Doors, RoomsIncludeOnlyWhatThePlanAllows) {
    const std::vector<SourceFile> tree = ReadSourceTree(SOLIDSUBDIV_SOURCE);
    ASSERT_GT(std::count_if(tree.begin(), tree.end(), [](const auto& f) { return RoomOf(f.path) == "sdc"; }), 3);
    EXPECT_THAT(Trespasses(tree), testing::IsEmpty());
}

TEST(Doors, PlantedTrespassesAreCaught) {
    const TemporaryFolder top;
    const auto write = [&](const std::string& path, const std::string& text) {
        std::filesystem::create_directories((top / path).parent_path());
        std::ofstream(top / path) << text;
    };
    write("far/good.h", "#include <vector>\n#include <solidsubdiv/vtr/level.h>\n#include <solidsubdiv/sdc/types.h>\n");
    write("far/good.cpp", "#include <solidsubdiv/far/internal/private.h>\n");
    write("sdc/parallel.cpp", "#include <tbb/parallel_for.h>\n");
    write("far/up.h", "#include <solidsubdiv/osd/evaluator.h>\n");
    write("vtr/loop.cpp", "  #  include  <tbb/parallel_for.h>  // fast\n");
    write("vtr/quoted.cpp", "#include \"level.h\"\n");
    write("kit/io/shown.h", "#include <pugixml.hpp>\n");
    write("kit/io/shown.cpp", "#include <pugixml.hpp>\n");
    write("kit/picture/leak.h", "#include <solidsubdiv/kit/picture/internal/scene.h>\n");
    write("kit/geometry/peek.cpp", "#include <solidsubdiv/far/internal/private.h>\n");
    write("kit/attic/new.h", "");
    write("validation/spline_oracle.cpp", "#include \"meshes.h\"\n");
    write("validation/meshes.h", "#include <vector>\n#include <solidsubdiv/sdc/schemes.h>\n");
    EXPECT_THAT(Trespasses(ReadSourceTree(top.Path())),
                testing::UnorderedElementsAre(
                    "far/up.h includes solidsubdiv/osd/evaluator.h: no door from far to osd",
                    "vtr/loop.cpp includes tbb/parallel_for.h: not a library of vtr",
                    "vtr/quoted.cpp includes level.h: headers of rooms are included as <solidsubdiv/ROOM/FILE>",
                    "kit/io/shown.h includes pugixml.hpp: a public header shows a library",
                    "kit/picture/leak.h includes solidsubdiv/kit/picture/internal/scene.h: a public header shows an "
                    "internal one, which is not installed",
                    "kit/geometry/peek.cpp includes solidsubdiv/far/internal/private.h: internal to far",
                    "kit/attic/new.h: in no room of the plan",
                    "validation/spline_oracle.cpp knows solidsubdiv/sdc/schemes.h: an oracle must not know our rooms"));
}

}  // namespace
}  // namespace SolidSubdiv::House
