/// All of kernels/math, in the order of dependence.
#ifndef MATHS_H
#define MATHS_H

#include "kernels/dialect.h"
#include "kernels/math/stable.h"
#include "kernels/math/random.h"
#include "kernels/math/sobol.h"
#include "kernels/math/rod.h"
#include "kernels/math/equiangular.h"
#include "kernels/math/pair_weight.h"
#include "kernels/math/linear_piece.h"
#include "kernels/math/mis.h"
#include "kernels/math/phase_function.h"
#include "kernels/math/phase_product.h"
#include "kernels/math/phase_lobes.h"
#include "kernels/math/rod_table.h"
#include "kernels/math/light_estimate.h"
#include "kernels/math/rod_estimate.h"
#include "kernels/math/surface_rod.h"
#include "kernels/math/transmittance.h"
#include "kernels/math/blur.h"
#include "kernels/math/eye_and_light.h"
#include "kernels/math/point_light.h"
#include "kernels/math/ray_light.h"

#endif
