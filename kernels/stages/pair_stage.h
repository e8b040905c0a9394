// Everything that a stage of the pair pipeline reads, in order. "EYE" and "LIGHT" stand for the kind of eye and of light that the program is built for.
#ifndef PAIR_STAGE_H
#define PAIR_STAGE_H
#include "kernels/math/maths.h"
#include "kernels/math/clip.h"
#include "kernels/math/long_sum.h"
#include "kernels/shared/samplers.h"
#include "kernels/shared/scene_features.h"
#include "kernels/shared/medium.h"
#include "kernels/shared/phase_lobe.h"
#include "kernels/shared/grid.h"
#include "kernels/shared/container.h"
#include "kernels/shared/eye_segment.h"
#include "kernels/shared/eye_point.h"
#include "kernels/shared/shadow_packet.h"
#include "LIGHT"
#include "kernels/stages/surroundings.h"
#include "kernels/stages/media.h"
#include "EYE"
#include "kernels/stages/connection.h"
#include "kernels/stages/shadow_segment.h"
#endif
