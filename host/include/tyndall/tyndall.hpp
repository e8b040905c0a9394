#pragma once
/// The renderer as a library: a scene, settings, an image. host/docs/library.md tells of threads, ownership, units and memory. Errors are the exceptions of
/// tyndall/error.hpp. This header includes the standard library only.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tyndall/error.hpp"
#include "tyndall/export.h"
#include "tyndall/layer.hpp"
#include "tyndall/scene_description.hpp"
#include "tyndall/settings.hpp"
#include "tyndall/stop.hpp"

namespace tyndall::api {

/// "0.1.0 (commit)" of the library that is loaded.
TYNDALL_API std::string version();

struct DeviceDescription {
    int index = 0;               ///< what RenderSettings::device may say, beside parts of the names
    std::string platform{}, name{};
    bool usable = false;
    std::string why_not{};         ///< if not usable
    std::uint64_t bytes = 0;     ///< of its memory
};

/// All OpenCL devices of this machine; empty if there is none.
TYNDALL_API std::vector<DeviceDescription> devices();

struct LoadOptions {
    std::map<std::string, std::string> definitions{};  ///< values for the <default>s of the file
    bool allow_outside = false;                      ///< let the scene name files outside its own folder
};

/// A scene that was found to be valid. Copies share it; it never changes, so threads may share it too.
class TYNDALL_API Scene {
public:
    /// From a file (host/docs/scenes.md). Throws SceneError, which begins with file:line:column.
    static Scene load(const std::filesystem::path& file, const LoadOptions& options = {});
    /// From the text of such a file; `folder` is where the files that it names are looked for, `name` stands for it in messages.
    static Scene parse(const std::string& xml, const std::filesystem::path& folder, const std::string& name, const LoadOptions& options = {});
    /// From data, all of which is copied. Throws SceneError, which names the element.
    explicit Scene(const SceneDescription& description);

    /// The same scene on another film, without a crop window. Throws UsageError for a size outside 1 ... 65536.
    Scene with_film(int width, int height) const;

    int width() const;
    int height() const;
    /// What is probably not meant, though it can be rendered.
    const std::vector<std::string>& warnings() const;

    struct State;
    const State& state() const { return *state_; }

private:
    explicit Scene(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

/// What was rendered. Spans are three floats a pixel, rows from the top; they live as long as the image. Moving an image keeps them; it cannot be copied.
class TYNDALL_API Image {
public:
    struct State;
    explicit Image(std::unique_ptr<State> state);
    ~Image();
    Image(Image&&) noexcept;
    Image& operator=(Image&&) noexcept;

    int width() const;
    int height() const;
    int passes() const;
    /// The picture: the sum of all layers. Linear radiance, W/m2/sr where the scene's lights are in watts.
    std::span<const float> beauty() const;
    /// One layer; empty if it was not rendered or the scene has no such light.
    std::span<const float> layer(Layer layer) const;
    /// Unbiased variance of the mean of the beauty; 0 after a single pass.
    std::span<const float> variance() const;
    /// Estimated root of the relative mean square error of the beauty; negative below two passes.
    double error() const;
    /// "passes", "time", "target error" or "interrupt".
    const std::string& stopped_by() const;
    /// What `tyndall render` writes as a report, JSON.
    const std::string& report() const;
    /// Writes layered OpenEXR into `exr`, whose name ends in .exr, and picture (.png) and report (.json) beside it, as `tyndall render -o` does. Throws UsageError, IoError.
    void write(const std::filesystem::path& exr) const;

private:
    std::unique_ptr<State> state_;
};

struct Progress {
    int passes_done = 0, passes_wanted = 0;  ///< wanted 0: until the time is up
    double seconds = 0, seconds_left = 0;    ///< left: estimated
    double error = -1;                       ///< estimated, as Image::error
};

/// The film after a whole pass, valid during the callback that it is given to.
class TYNDALL_API Preview {
public:
    struct State;
    explicit Preview(const State& state) : state_(state) {}
    /// Writes the beauty so far, width * height * 3 floats. Throws UsageError for a span of another size.
    void beauty(std::span<float> rgb) const;

private:
    const State& state_;
};

enum class LogLevel { info, warning, error };

/// What a render may do beside rendering. Callbacks are called on the thread that called `render`, between passes; what they throw ends the render and leaves it.
struct RenderOptions {
    std::function<bool(const Progress&, const Preview&)> progress{};  ///< after every pass; false ends the render with the passes so far
    std::function<void(LogLevel, const std::string&)> log{};          ///< sentences for people, errors too, which are thrown as well; without it nothing is printed anywhere
    std::uint64_t max_bytes = 0;  ///< refuse, with ResourceError and before any work, what is estimated to take more memory on host or device; 0: no bound
};

/// Renders. Settings that do not say when to stop mean 16 passes. RenderSettings::stop may be raised from another thread: the pass in progress is abandoned and the
/// passes before it are returned. Throws UsageError, NoDeviceError, DeviceError.
TYNDALL_API Image render(const Scene& scene, const RenderSettings& settings, const RenderOptions& options = {});

}  // namespace tyndall::api
