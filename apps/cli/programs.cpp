// SPDX-License-Identifier: Apache-2.0
// Finds programs beside this one and becomes them.
#include <solidsubdiv/apps/cli/programs.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Cli {

namespace {

std::string PathOf(const Program& program) {
    std::error_code ignored;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", ignored);
    return (self.parent_path() / ("solidsubdiv-" + std::string(program.name))).string();
}

}  // namespace

bool IsThere(const Program& program) { return access(PathOf(program).c_str(), X_OK) == 0; }

void Become(const Program& program, int argc, char** argv) {
    std::string path = PathOf(program);
    std::vector<char*> arguments = {path.data()};
    for (int i = 2; i < argc; ++i) arguments.push_back(argv[i]);
    arguments.push_back(nullptr);
    execv(path.c_str(), arguments.data());
    throw IoError(path + ": " + std::strerror(errno) + "; it is built with -D" + std::string(program.option) + "=ON");
}

}  // namespace SolidSubdiv::Cli
