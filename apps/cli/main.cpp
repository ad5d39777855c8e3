// SPDX-License-Identifier: Apache-2.0
// The program solidsubdiv.
#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    CLI::App app("Subdivision of solids and surfaces");
    app.set_version_flag("--version", "solidsubdiv " SOLIDSUBDIV_VERSION);
    CLI11_PARSE(app, argc, argv);
    return 0;
}
