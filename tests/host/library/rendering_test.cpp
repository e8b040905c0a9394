/// A render through the shared library: the program's image, callbacks, cancellation.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "../../support/child_process.hpp"
#include "film/exr.hpp"
#include "scenes.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

TEST(LibraryRender, IsTheProgramsImage)
{
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "fog.xml") << fog_as_text();
    const api::Image image = api::render(api::Scene::load(folder.path() / "fog.xml"), few_passes(3));
    image.write(folder.path() / "library.exr");
    const ProcessResult ran = run_process({TYNDALL_PROGRAM, "render", "fog.xml", "--passes", "3", "--lights", "64", "--no-selftest", "-o", "program.exr"}, {.folder = folder.path()});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const ExrImage a = read_exr(folder.path() / "library.exr"), b = read_exr(folder.path() / "program.exr");
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (const auto& [name, channel] : b.channels) EXPECT_EQ(a.channels.at(name).values, channel.values) << name;
    for (std::size_t i = 0; i < b.channels.at("R").values.size(); ++i) {
        EXPECT_EQ(image.beauty()[3 * i], b.channels.at("R").values[i]);
        EXPECT_EQ(image.variance()[3 * i + 1], b.channels.at("variance.G").values[i]);
        EXPECT_EQ(image.layer(Layer::media_to_media)[3 * i + 2], b.channels.at("media_to_media.B").values[i]);
    }
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "library.png"));
}

TEST(LibraryRender, LayersSumToTheImage)
{
    const api::Image image = api::render(api::Scene(fog_as_data()), few_passes(2));
    std::vector<double> sum(image.beauty().size());
    for (std::size_t l = 0; l < layer_count; ++l) {
        const auto layer = image.layer(static_cast<Layer>(l));
        for (std::size_t i = 0; i < layer.size(); ++i) sum[i] += layer[i];
    }
    for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(sum[i], image.beauty()[i], 1e-5 * std::abs(sum[i]) + 1e-30);  // each is rounded to float
    EXPECT_GT(image.layer(Layer::media_to_media).size(), 0u);
}

TEST(LibraryRender, ReportIsJson)
{
    const api::Image image = api::render(api::Scene(fog_as_data()), few_passes(2));
    const auto report = nlohmann::json::parse(image.report());
    EXPECT_EQ(report.at("passes"), 2);
    EXPECT_EQ(image.stopped_by(), "passes");
    EXPECT_EQ(image.passes(), 2);
    EXPECT_GT(image.error(), 0);
}

TEST(LibraryRender, SixteenPassesUnlessToldOtherwise)
{
    RenderSettings settings = few_passes(0);
    settings.method = Method::path;
    EXPECT_EQ(api::render(api::Scene(fog_as_data()), settings).passes(), 16);
}

TEST(LibraryCallbacks, AreCalledAfterEveryPassAndMayEndIt)
{
    std::vector<int> done;
    std::vector<float> preview(3 * 24 * 18);
    std::thread::id thread;
    const api::RenderOptions options{.progress = [&](const api::Progress& p, const api::Preview& film) {
        done.push_back(p.passes_done), thread = std::this_thread::get_id();
        film.beauty(preview);
        EXPECT_EQ(p.passes_wanted, 5);
        EXPECT_THROW(film.beauty(std::span<float>(preview).first(5)), UsageError);
        return p.passes_done < 3;
    }};
    const api::Image image = api::render(api::Scene(fog_as_data()), few_passes(5), options);
    EXPECT_EQ(done, (std::vector{1, 2, 3}));
    EXPECT_EQ(thread, std::this_thread::get_id());
    EXPECT_EQ(image.passes(), 3);
    EXPECT_EQ(image.stopped_by(), "interrupt");
    EXPECT_EQ(preview, std::vector<float>(image.beauty().begin(), image.beauty().end()));
}

TEST(LibraryCallbacks, WhatTheyThrowLeavesTheRender)
{
    const api::RenderOptions options{.progress = [](const api::Progress&, const api::Preview&) -> bool { throw std::logic_error("mine"); }};
    EXPECT_THROW(api::render(api::Scene(fog_as_data()), few_passes(2), options), std::logic_error);
}

TEST(LibraryCallbacks, TheLogHearsTheErrorThatIsThrown)
{
    std::vector<std::string> errors;
    const api::RenderOptions options{.log = [&](api::LogLevel level, const std::string& text) { if (level == api::LogLevel::error) errors.push_back(text); }, .max_bytes = 1000};
    std::string thrown;
    try {
        api::render(api::Scene(fog_as_data()), few_passes(1), options);
    } catch (const ResourceError& error) {
        thrown = error.what();
    }
    EXPECT_THAT(thrown, testing::HasSubstr("1000"));
    EXPECT_THAT(errors, testing::ElementsAre(thrown));
}

TEST(LibraryCallbacks, TheLogHearsWarnings)
{
    api::SceneDescription scene = fog_as_data();
    scene.emitters[1].medium = api::vacuum;
    int warnings = 0;
    api::render(api::Scene(scene), few_passes(1), {.log = [&](api::LogLevel level, const std::string& text) { warnings += level == api::LogLevel::warning && text.find("point") != std::string::npos; }});
    EXPECT_EQ(warnings, 1);
}

TEST(LibraryRender, AFlagEndsItFromAnotherThread)
{
    StopFlag stop;
    RenderSettings settings = few_passes(1 << 20);
    settings.method = Method::path, settings.stop = &stop;
    std::thread other;
    const api::RenderOptions options{.progress = [&](const api::Progress& p, const api::Preview&) {
        if (p.passes_done == 2) other = std::thread([&] { stop.raise(); });
        return true;
    }};
    const api::Image image = api::render(api::Scene(fog_as_data()), settings, options);
    other.join();
    EXPECT_GE(image.passes(), 2);
    EXPECT_EQ(image.stopped_by(), "interrupt");
}

TEST(LibraryRender, TwoAtOnceAreAsOneAfterTheOther)
{
    const api::Scene scene(fog_as_data());
    const api::Image alone = api::render(scene, few_passes(2));
    std::vector<float> images[2];
    std::thread threads[2];
    for (int i = 0; i < 2; ++i) threads[i] = std::thread([&, i] {
        const api::Image image = api::render(scene, few_passes(2));
        images[i].assign(image.beauty().begin(), image.beauty().end());
    });
    for (std::thread& thread : threads) thread.join();
    for (const auto& image : images) EXPECT_EQ(image, std::vector<float>(alone.beauty().begin(), alone.beauty().end()));
}

TEST(LibraryDevices, AreListed)
{
    const auto devices = api::devices();
    ASSERT_FALSE(devices.empty());
    EXPECT_TRUE(std::any_of(devices.begin(), devices.end(), [](const auto& d) { return d.usable && !d.name.empty() && d.bytes > 0; }));
    EXPECT_THAT(api::version(), testing::StartsWith("0."));
}

}  // namespace
