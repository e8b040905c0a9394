/// Writes what the device's compiler would read, for a compiler to look at: `write_kernels FOLDER` for the covering set of kernels and the masks of the scenes in scenes/ and tests/images,
/// `write_kernels FOLDER --all` for every light with every feature, kind of eye, precision and lane width. A text that several builds share is written once; the file `builds` has a line for each:
/// name of the text, options.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include "device/case_evaluator.hpp"
#include "device/kernel_source.hpp"
#include "kernels/shared/host_features.hpp"
#include "scene/load_scene.hpp"
#include "scene/scene_features.hpp"
#include "tests/support/kernel_variants.hpp"

namespace tyndall::test {
namespace {

namespace fs = std::filesystem;

/// Programs of virtual ray lights for what each scene calls for, with every lane width.
std::vector<PairProgram> programs_of_scenes()
{
    std::vector<PairProgram> programs;
    for (const char* folder : {"scenes", "tests/images/scenes"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(TYNDALL_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != ".xml" || (folder == std::string_view("scenes") && entry.path().filename() != "scene.xml")) continue;  // others are parts of scenes
            const SceneFeatures features = features_of(load_scene(entry.path()));
            for (const int lanes : {1, 4, 8, 16}) {
                programs.push_back({.eyes = EyeKind::segments, .features = features.media_to_media, .lanes = lanes});
                programs.push_back({.eyes = EyeKind::points, .features = features.media_to_surface, .lanes = lanes});
            }
        }
    return programs;
}

std::vector<PairProgram> covering_programs()
{
    std::vector<PairProgram> programs = programs_of_scenes();
    for (const Choices& choices : covering_choices()) programs.push_back(program_of(choices));
    return programs;
}

/// Every light with no feature, each single one, and all: as `allowed` lets it be built.
std::vector<PairProgram> all_programs()
{
    std::map<std::string, PairProgram> programs;
    Choices choices(choice_counts().size(), 0);
    const Choices counts = choice_counts();
    const std::size_t features = counts.size() - scene_feature_list.size();
    for (choices[0] = 0; choices[0] < counts[0]; ++choices[0])
        for (choices[1] = 0; choices[1] < counts[1]; ++choices[1])
            for (choices[2] = 0; choices[2] < counts[2]; ++choices[2])
                for (const int precision : {32, 64})
                    for (std::size_t on = 0; on <= scene_feature_list.size() + 1; ++on) {
                        Choices one = choices;
                        for (std::size_t f = 0; f < scene_feature_list.size(); ++f) one[features + f] = on > scene_feature_list.size() || f + 1 == on;
                        PairProgram program = program_of(allowed(one));
                        program.precision = precision;
                        programs.emplace(name_of(allowed(one)) + "_" + std::to_string(precision), program);
                    }
    std::vector<PairProgram> list;
    for (const auto& [name, program] : programs) list.push_back(program);
    return list;
}

void write(const fs::path& folder, const std::vector<PairProgram>& programs)
{
    fs::create_directories(folder);
    std::map<std::string, std::string> names;
    std::set<std::string> builds;
    std::ofstream(folder / "selftest.cl", std::ios::binary) << flattened_kernel("kernels/selftest/evaluate_cases.cl", {});
    for (const int lanes : {1, 4, 8, 16}) builds.insert("selftest.cl " + case_options(lanes));
    std::ofstream(folder / "baseline.cl", std::ios::binary) << flattened_kernel("kernels/baseline/scalar_pairs.cl", {});
    for (const char* options : {"-DANISOTROPIC=0 -DCOLOURED=0", "-DANISOTROPIC=0 -DCOLOURED=1", "-DANISOTROPIC=1 -DCOLOURED=0", "-DANISOTROPIC=1 -DCOLOURED=1"})
        builds.insert(std::string("baseline.cl -cl-std=CL1.2 ") + options);
    for (const PairProgram& program : programs)
        for (const KernelBuild& build : kernel_builds(program)) {
            const auto [text, is_new] = names.try_emplace(kernel_text(program, build), build.file() + "_" + std::to_string(names.size()) + ".cl");
            if (is_new) std::ofstream(folder / text->second, std::ios::binary) << text->first;
            builds.insert(text->second + " " + build.options);
        }
    std::ofstream list(folder / "builds");
    for (const std::string& build : builds) list << build << '\n';
    std::cout << programs.size() << " programs, " << builds.size() << " builds, " << names.size() + 2 << " texts\n";
}

}  // namespace
}  // namespace tyndall::test

int main(int count, char** arguments)
{
    using namespace tyndall::test;
    const bool all = count == 3 && std::string_view(arguments[2]) == "--all";
    if (count != 2 && !all) {
        std::cerr << "write_kernels: say where to: write_kernels FOLDER [--all]\n";
        return 2;
    }
    write(arguments[1], all ? all_programs() : covering_programs());
}
