#include "path_tracing/layer_track.hpp"

#include <gtest/gtest.h>

using namespace tyndall;
using Vertex = LayerTrack::Vertex;

namespace {

LayerTrack after(std::initializer_list<char> events)  // m: medium, s: surface, g: glass or mirror
{
    LayerTrack track;
    for (const char e : events) e == 'g' ? track.pass_specular() : track.scatter(e == 'm' ? Vertex::medium : Vertex::surface);
    return track;
}

TEST(LayerTrack, FirstTwoVerticesDecideTheLayer)
{
    EXPECT_EQ(after({}).of_light(), Layer::emitted);
    EXPECT_EQ(after({'m'}).of_light(), Layer::single);
    EXPECT_EQ(after({'s'}).of_light(), Layer::surface_direct);
    EXPECT_EQ(after({'m', 'm'}).of_light(), Layer::media_to_media);
    EXPECT_EQ(after({'m', 's'}).of_light(), Layer::surface_to_media);
    EXPECT_EQ(after({'s', 'm'}).of_light(), Layer::media_to_surface);
    EXPECT_EQ(after({'s', 's'}).of_light(), Layer::surface_indirect);
    EXPECT_EQ(after({'m', 's', 'm', 's', 'g'}).of_light(), Layer::surface_to_media);
}

TEST(LayerTrack, OnlyGlassBetweenTheFirstTwoVerticesMakesTheSubLayer)
{
    EXPECT_EQ(after({'g', 'g'}).of_light(), Layer::emitted);
    EXPECT_EQ(after({'g', 'm'}).of_light(), Layer::single);
    EXPECT_EQ(after({'m', 'g'}).of_light(), Layer::single_specular);
    EXPECT_EQ(after({'s', 'g', 's'}).of_light(), Layer::surface_indirect_specular);
    EXPECT_EQ(after({'s', 'g', 'm', 's'}).of_light(), Layer::media_to_surface_specular);
    EXPECT_EQ(after({'m', 'm', 'g'}).of_light(), Layer::media_to_media);
}

TEST(LayerTrack, WhatCanBeReachedShrinksToTheLayer)
{
    EXPECT_EQ(after({}).reachable(), LayerSet::all());
    EXPECT_EQ(after({'g'}).reachable(), LayerSet::all());
    LayerSet from_medium;
    for (const Layer layer : {Layer::single, Layer::surface_to_media, Layer::media_to_media}) from_medium.add(layer).add(specular(layer));
    EXPECT_EQ(after({'m'}).reachable(), from_medium);
    EXPECT_EQ(after({'m', 'g'}).reachable(),
              LayerSet().add(Layer::single_specular).add(Layer::surface_to_media_specular).add(Layer::media_to_media_specular));
    EXPECT_EQ(after({'s', 'm', 's'}).reachable(), LayerSet().add(Layer::media_to_surface));
}

}  // namespace
