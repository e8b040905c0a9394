/// Programs that name some fields of a struct get no warning for the others: compiled with -Wextra and -Werror.
#include <tyndall/backend.hpp>
#include <tyndall/tyndall.hpp>

namespace {

using namespace tyndall;

[[maybe_unused]] const RenderSettings settings{.passes = 2};
[[maybe_unused]] const OpenClHandles handles{.context = nullptr};
[[maybe_unused]] const api::LoadOptions load{.allow_outside = true};
[[maybe_unused]] const api::RenderOptions options{.max_bytes = 1};
[[maybe_unused]] const api::SceneDescription scene{.media = {{.name = "fog", .phase = {.g = .5}}}, .bsdfs = {{.eta = 1.5}}, .meshes = {{.bsdf = 0}}, .emitters = {{.medium = 0}}, .camera = {.width = 8}};
[[maybe_unused]] const api::Grid grid{.size = {1, 1, 1}};
[[maybe_unused]] const api::BackendDescription backend{.lanes = 4};
[[maybe_unused]] const api::ConnectOptions connect{.seed = 2};

}  // namespace
