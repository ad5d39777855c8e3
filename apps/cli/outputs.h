// SPDX-License-Identifier: Apache-2.0
// Output files that all appear under their names when everything has succeeded, and otherwise not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace SolidSubdiv::Cli {

class Outputs {
  public:
    Outputs() = default;
    ~Outputs();
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /// Announces a file and gives the place to write it to meanwhile: of the same name, in a hidden folder beside it.
    /// Called before any long work, so that a name that can't be written is found out first.
    /// @throws UsageError where two outputs have one name, IoError where the file can't be made
    std::filesystem::path Stage(const std::filesystem::path& file);

    /// Makes a folder for outputs where there is none; it goes again where nothing came into it.
    /// @throws IoError where it can't be made
    void MakeFolder(const std::filesystem::path& folder);

    /// Moves every staged file to its name, and what a format wrote beside it (.node and .ele). @throws IoError
    void Commit();

    /// A text in which staged files have their final names.
    std::string WithFinalNames(std::string text) const;

  private:
    std::filesystem::path FolderBeside(const std::filesystem::path& file);

    std::vector<std::filesystem::path> files_;    // absolute, final
    std::vector<std::filesystem::path> made_;     // folders that were not there
    std::vector<std::filesystem::path> folders_;  // hidden, each beside the files that it holds for the time being
};

}  // namespace SolidSubdiv::Cli
