// SPDX-License-Identifier: Apache-2.0
// Talks with vtk_peer.py through two pipes: Debian's C++ VTK brings 266 packages, its Python module is there for tests.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>

#include "perf/surface_peers.h"

namespace SolidSubdiv::Perf {

namespace {

/// A child that reads lines and answers with lines; it ends when its input does.
class Child {
  public:
    /// @param environment NAME=VALUE, in place of ours
    Child(std::vector<std::string> command, std::vector<std::string> environment) {
        int to_child[2], from_child[2];
        if (pipe(to_child) != 0 || pipe(from_child) != 0) throw std::runtime_error("no pipe");
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, to_child[0], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, from_child[1], STDOUT_FILENO);
        for (const int end : {to_child[0], to_child[1], from_child[0], from_child[1]}) {
            posix_spawn_file_actions_addclose(&actions, end);
        }
        const auto pointers = [](std::vector<std::string>& texts) {
            std::vector<char*> list;
            for (std::string& text : texts) list.push_back(text.data());
            list.push_back(nullptr);
            return list;
        };
        const int error = posix_spawn(&id_, command[0].c_str(), &actions, nullptr, pointers(command).data(),
                                      pointers(environment).data());
        posix_spawn_file_actions_destroy(&actions);
        close(to_child[0]);
        close(from_child[1]);
        input_ = fdopen(to_child[1], "w");
        output_ = fdopen(from_child[0], "r");
        if (error != 0) id_ = 0;
        std::signal(SIGPIPE, SIG_IGN);  // a child that ended shows when its answer is read
    }
    ~Child() {
        std::fclose(input_);
        std::fclose(output_);
        if (id_ > 0) waitpid(id_, nullptr, 0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    std::FILE* input() { return input_; }
    /// What it says to all that was written; nothing if it ended.
    std::optional<std::string> Answer() {
        std::fflush(input_);
        std::string line;
        for (int c; (c = std::fgetc(output_)) != EOF;) {
            if (c == '\n') return line;
            line += static_cast<char>(c);
        }
        return {};
    }
    /// `count` numbers in answer to a line.
    std::vector<double> Ask(const char* line, std::size_t count) {
        std::fprintf(input_, "%s\n", line);
        const std::string answer = Answer().value_or("nothing");
        std::vector<double> numbers;
        const char* at = answer.c_str();
        for (char* end; numbers.size() < count; at = end) {
            numbers.push_back(std::strtod(at, &end));
            if (end == at) throw std::runtime_error("vtk_peer.py answers '" + answer + "' to '" + line + "'");
        }
        return numbers;
    }

  private:
    pid_t id_ = 0;
    std::FILE *input_ = nullptr, *output_ = nullptr;
};

}  // namespace

SurfacePeers VtkPeers(const TestShapes::Shape& shape, int n_levels, Freed freed) {
    const auto child = std::make_shared<Child>(
        std::vector<std::string>{"/usr/bin/python3", SOLIDSUBDIV_PERF_SOURCE "/vtk_peer.py"}, EnvironmentOf(freed));
    std::fprintf(child->input(), "%d %zu %d\n", shape.n_vertices, shape.triangles.size() / 3, n_levels);
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        std::fprintf(child->input(), i % 3 == 2 ? "%.17g\n" : "%.17g ", shape.positions[i]);
    }
    for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
        std::fprintf(child->input(), i % 3 == 2 ? "%d\n" : "%d ", shape.triangles[i]);
    }
    if (child->Answer() != "ready") return {.missing = "VTK's Python module was not there for /usr/bin/python3."};
    return {.butterfly = {{.name = "VTK, float",
                           .run_apart =
                               [child] {
                                   const auto seconds = child->Ask("run", 2);
                                   return Seconds{seconds[0], seconds[1]};
                               },
                           .sums =
                               [child] {
                                   const auto s = child->Ask("sums", 8);
                                   return PointSums{s[0], s[1], {s[2], s[3], s[4]}, {s[5], s[6], s[7]}};
                               }}}};
}

}  // namespace SolidSubdiv::Perf
