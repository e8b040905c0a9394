#pragma once
/// What the readers of the single elements share: the scene that grows, and who has been read already.
#include <map>

#include "scene/picture_files.hpp"
#include "scene/properties.hpp"
#include "scene/scene_files.hpp"
#include "scene/volume_files.hpp"

namespace tyndall {

struct SceneBuilder {
    const SceneDocument& document;
    SceneFiles& files;
    Scene scene{};
    std::map<const XmlElement*, int> media{}, bsdfs{}, textures{};  ///< index of what was read from an element
    std::map<std::pair<std::filesystem::path, std::string>, VolumeFile> volume_files{};  ///< every grid of every file of voxels is read once

    /// Adds "file:line:column: message" to the scene's warnings.
    void warn(const SourceLocation& where, const std::string& message) { scene.warnings.push_back(to_string(where) + ": " + message); }
};

/// Index of the medium in scene.media; read at the first call. `phase` functions are read in media.cpp too.
int read_medium(SceneBuilder& builder, const XmlElement& element);

/// What type="heterogeneous" adds to a medium: extinction, albedo and their volumes.
void read_heterogeneous(SceneBuilder& builder, Properties& properties, Medium& medium);

/// The medium among the nested objects: at most one, unless roles tell them apart. vacuum if there is none.
int read_only_medium(SceneBuilder& builder, Properties& properties);

/// A colour that may be a texture.
struct SurfaceColour {
    Rgb largest{0};      ///< the colour, or the texture's largest values
    int texture = none;  ///< index into Scene::textures
};

/// <rgb>, <float>, or <texture name=...>; values between 0 and 1.
SurfaceColour read_reflectance(SceneBuilder& builder, Properties& properties, const std::string& name, double fallback);

/// The picture that the parameter `filename` names; values are linear unless `raw` leaves them as the file has them.
Picture read_scene_picture(SceneBuilder& builder, Properties& properties, bool raw);

/// Index of the bsdf in scene.bsdfs; read at the first call.
int read_bsdf(SceneBuilder& builder, const XmlElement& element);

/// Index of Mitsuba's bsdf of a shape that names none: diffuse .5, or 0 if it glows.
int default_bsdf(SceneBuilder& builder, bool glows);

/// Adds an emitter of the scene, or, with `shape` an index, the area emitter of that shape. Returns its index.
int read_emitter(SceneBuilder& builder, const XmlElement& element, int shape = none);

/// Adds a shape, with whatever is nested in it.
void read_shape(SceneBuilder& builder, const XmlElement& element);

/// Reads the camera and its film.
Camera read_sensor(SceneBuilder& builder, const XmlElement& element);

}  // namespace tyndall
