#pragma once
/// One pass: an independent set of light paths and one camera sample per pixel.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "device/pair_stage.hpp"
#include "eye_tracing/eye_tracing.hpp"
#include "film/pass_image.hpp"
#include "light_tracing/light_tracing.hpp"
#include "pipeline/build_masks.hpp"
#include "pipeline/eye_connector.hpp"
#include "pipeline/gather_connector.hpp"
#include "pipeline/render_state.hpp"
#include "tiling/connect_pairs.hpp"

namespace tyndall {

struct PassResult {
    PassImage image;
    PixelFeatures features;
};

/// Seconds and counts per stage, over all passes so far.
class StageClock {
public:
    /// Runs `work` and adds its time to `stage`.
    template <typename Work>
    auto time(const std::string& stage, Work&& work);
    void add(const std::string& stage, double seconds, std::uint64_t count);
    std::vector<StageTime> stages() const { return stages_; }

private:
    std::vector<StageTime> stages_;
};

class PassRenderer {
public:
    /// Opens the device and compiles kernels only if the plan has virtual lights. `unchecked`: masks instead of the scene's or the settings' own; a wrong one
    /// gives a wrong image, which is what tests want. Throws UsageError, NoDeviceError, DeviceError.
    PassRenderer(const Scene& scene, const RenderSettings& settings, const std::optional<BuildMasks>& unchecked = {});

    PassResult render(std::uint64_t pass);
    const LayerPlan& plan() const { return plan_; }
    const SceneFeatures& features() const { return features_; }
    const ConnectCounts& counts() const { return counts_; }
    /// Adds everything that was counted and timed.
    void fill(Report& report) const;
    /// Counts on from a report that `fill` has filled after earlier passes of the same render.
    void continue_from(const Report& earlier);
    /// All that the bytes of its passes depend on, but the program's version and the scene.
    std::vector<StateSetting> settings() const;

private:
    /// Density estimation by one kind of light, ready to run.
    struct Gathering {
        GatherPlan plan;
        std::unique_ptr<GatherConnector> connector{};
        std::uint64_t paths = 0;  ///< per pass
    };

    /// A layer of straight connections to virtual lights, ready to run.
    struct Connection {
        Layer layer;
        std::unique_ptr<EyeConnector> connector{};
    };

    void prepare_lights();
    SelftestReport check_devices();
    std::unique_ptr<EyeConnector> make_connector(Layer layer);
    Gathering make_gathering(const GatherPlan& gather);
    std::uint64_t count_paths(const LightTechnique& technique, std::uint32_t lights, const LayerSet& layers) const;
    LightTracingSettings light_settings(const LightTechnique& technique) const;
    void add_gathered(std::uint64_t pass, const EyeRecords& eyes, PassImage& image);
    const ConnectSettings* connect_settings() const;
    std::uint64_t programs_built() const;
    void add_savings(Report& report) const;
    template <typename Connector>
    void add_connector(const Connector& connector, const std::string& layer, Report& report) const;
    void add_bias(Report& report) const;
    void add_devices(Report& report) const;
    void add_device_settings(std::vector<StateSetting>& all) const;
    void add_light_settings(std::vector<StateSetting>& all) const;
    const EyeConnector* connector_of(std::string_view layer) const;
    void add_virtual_lights(std::uint64_t pass, const EyeRecords& eyes, PassImage& image);
    void connect(const VirtualLights& lights, std::uint64_t pass, std::initializer_list<Layer> layers, const EyeRecords& eyes, PassImage& image);
    void note_worst_pair(const EyeConnector::Worst& worst, std::uint64_t pass, Layer layer, PassImage& image);
    void add_host_layers(std::uint64_t pass, PassImage& image);

    const Scene& scene_;
    RenderSettings settings_;
    int max_depth_;
    SceneFeatures features_;
    LayerPlan plan_;
    BuildMasks masks_;
    Visibility visibility_;
    std::vector<Device> devices_;  ///< all with the lane width of the first
    std::vector<Connection> connections_;  ///< one for each layer that virtual lights carry
    std::vector<Gathering> gathers_;       ///< one for each of the plan's
    std::optional<SelftestReport> selftest_;
    std::uint64_t light_paths_ = 0, surface_light_paths_ = 0;  ///< for lights in media and for lights on surfaces
    StageClock clock_;
    ConnectCounts counts_;
    WorstPairReport worst_pair_;
    std::uint64_t virtual_lights_ = 0, eye_segments_ = 0, eye_points_ = 0;
    Report earlier_;  ///< what passes before this renderer's have counted, where no member here goes on with it
};

}  // namespace tyndall
