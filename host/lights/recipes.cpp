/// Which technique carries which layer, method by method.
#include <algorithm>
#include <stdexcept>

#include "lights/light_technique.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// A layer, and the method of the technique that carries it.
struct Carried {
    Layer layer;
    std::string_view method;
};

struct NamedRecipe {
    std::string_view method, title;
    std::vector<Carried> layers;  ///< the others: camera ray, next-event estimation, path tracing
};

/// Methods that are made of several techniques.
const std::vector<NamedRecipe>& named_recipes()
{
    static const std::vector<NamedRecipe> recipes{
        {"talk", "photons on surfaces, photon beams for light that reaches media from lights and surfaces, virtual ray lights for what media scatter",
         {{Layer::single, "beams"},
          {Layer::single_specular, "beams"},
          {Layer::surface_to_media, "beams"},
          {Layer::surface_to_media_specular, "beams"},
          {Layer::media_to_media, "vrl"},
          {Layer::media_to_media_specular, "beams"},
          {Layer::media_to_surface, "vrl"},
          {Layer::media_to_surface_specular, "photons"},
          {Layer::surface_indirect, "photons"},
          {Layer::surface_indirect_specular, "photons"},
          {Layer::surface_direct_specular, "photons"}}},
    };
    return recipes;
}

/// on_surfaces: of the method's lights those that stand on surfaces, or the others.
const LightTechnique* find_technique(std::string_view method, bool on_surfaces = false)
{
    for (const LightTechnique& technique : light_techniques())
        if (technique.on_surfaces == on_surfaces && (technique.method == method || (!technique.clamped_method.empty() && technique.clamped_method == method))) return &technique;
    return nullptr;
}

void add_gathered(const LightTechnique* technique, Layer layer, std::vector<Gathered>& gathered)
{
    if (!technique->carries.contains(layer)) throw std::logic_error(std::string(technique->name) + " does not carry " + std::string(name(layer)));
    auto found = std::find_if(gathered.begin(), gathered.end(), [&](const Gathered& g) { return g.technique == technique; });
    if (found == gathered.end()) found = gathered.insert(found, {technique, {}});
    found->layers.add(layer);
}

Recipe made_of(const NamedRecipe& named)
{
    Recipe recipe{.title = std::string(named.title)};
    for (const Carried& carried : named.layers) {
        const LightTechnique* technique = find_technique(carried.method);
        if (!technique) throw std::logic_error("the recipe \"" + std::string(named.method) + "\" names \"" + std::string(carried.method) + "\", which is no light");
        if (technique->gathered()) add_gathered(technique, carried.layer, recipe.gathered);
        else recipe.connected = technique;
    }
    return recipe;
}

}  // namespace

Recipe recipe_of(Method method)
{
    if (method == Method::path) return {.title = "path tracing of every layer"};
    if (const LightTechnique* technique = find_technique(method.name())) {
        const bool clamped = technique->method != method.name();
        Recipe recipe{.on_surfaces = find_technique(method.name(), true), .clamped = clamped, .title = std::string(technique->title) + (clamped ? ", clamped" : "")};
        if (technique->gathered()) recipe.gathered.push_back({technique, technique->carries});
        else recipe.connected = technique;
        return recipe;
    }
    for (const NamedRecipe& named : named_recipes())
        if (named.method == method.name()) return made_of(named);
    std::string known;
    for (const Method each : all_methods()) known += (known.empty() ? "" : ", ") + std::string(each.name());
    throw UsageError("unknown method \"" + std::string(method.name()) + "\"; there are: " + known);
}

const LightTechnique* lights_for(Layer layer, const Recipe& recipe)
{
    for (const Gathered& g : recipe.gathered)
        if (g.layers.contains(layer)) return g.technique;
    for (const LightTechnique* lights : {recipe.connected, recipe.on_surfaces})
        if (lights && lights->carries.contains(layer)) return lights;
    return nullptr;
}

std::vector<std::string_view> methods_that_carry(Layer layer)
{
    std::vector<std::string_view> names;
    for (const Method method : all_methods())
        if (method == Method::path || lights_for(layer, recipe_of(method))) names.push_back(method.name());
    return names;
}

const LightTechnique* technique_of(Method method) { return recipe_of(method).connected; }
bool is_clamped(Method method) { return recipe_of(method).clamped; }

bool is_thick(Method method)
{
    const Recipe recipe = recipe_of(method);
    return !recipe.gathered.empty() || (recipe.connected && recipe.connected->is_thick);
}

std::vector<Method> all_methods()
{
    std::vector<Method> methods{Method::vrl};
    for (const LightTechnique& technique : light_techniques()) {
        if (technique.on_surfaces) continue;
        if (technique.method != Method::vrl.name()) methods.push_back(Method(technique.method));
        if (!technique.clamped_method.empty()) methods.push_back(Method(technique.clamped_method));
    }
    for (const NamedRecipe& named : named_recipes()) methods.push_back(Method(named.method));
    methods.push_back(Method::path);
    return methods;
}

}  // namespace tyndall
