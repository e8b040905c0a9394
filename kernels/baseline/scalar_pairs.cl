// The baseline that throughput is set beside (`tyndall bench`, bench/pairs): virtual ray lights as a competent reader of the paper would write them down. One pixel per work-item, a loop over the
// lights, scalar floats, the library's functions, the talk's formulas: closest points of the two lines, h, asinh(v sin(theta) / h) and sinh for the marginal
// [Novak et al. 2012], the angle by atan and tan for the conditional [Kulla and Fajardo 2012], the densities spelt out. Records and random numbers are
// those of kernels/, so that both kernels compute the same sums; none of its mathematics is used.
// Build options: ANISOTROPIC and COLOURED, each 0 or 1.

typedef struct {
    float ox, oy, oz, length;
    float dx, dy, dz;
    uint medium;
    float r, g, b;
    uint depth, pixel, key, padding_0, padding_1;
} Eye;

typedef struct {
    float ox, oy, oz, length;
    float dx, dy, dz;
    uint medium;
    float r, g, b;
    uint depth;
    float channel_r, channel_g, channel_b;
    uint is_short;
} RayLight;

typedef struct {
    float sigma_t_r, sigma_t_g, sigma_t_b, g;
    float sigma_s_r, sigma_s_g, sigma_s_b;
    uint padding;
} Medium;

static uint hash(uint x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

static float phase(float cosine, float g)
{
    if (!ANISOTROPIC) return 1.0f / (4.0f * M_PI_F);
    float k = 1.0f + g * g - 2.0f * g * cosine;
    return (1.0f - g * g) / (4.0f * M_PI_F * k * sqrt(k));
}

__kernel void scalar_pairs(__global const Eye* eyes, __global const RayLight* lights, uint light_count, __global const Medium* media, __global float* sums)
{
    uint pixel = (uint)get_global_id(0);
    Eye eye = eyes[pixel];
    Medium medium = media[0];
    float3 o = (float3)(eye.ox, eye.oy, eye.oz), a = (float3)(eye.dx, eye.dy, eye.dz);
    float3 sigma_t = (float3)(medium.sigma_t_r, medium.sigma_t_g, medium.sigma_t_b), sigma_s = (float3)(medium.sigma_s_r, medium.sigma_s_g, medium.sigma_s_b);
    float3 sum = (float3)(0.0f);
    for (uint i = 0; i < light_count; ++i) {
        RayLight light = lights[i];
        float3 q = (float3)(light.ox, light.oy, light.oz) - o, b = (float3)(light.dx, light.dy, light.dz);
        uint first_shift = hash(i + 0x9e3779b9u), x = hash(eye.key + first_shift), y = hash(x ^ hash(first_shift + 0x9e3779b9u));
        float xi_1 = (x >> 8) * 0x1p-24f, xi_2 = (y >> 8) * 0x1p-24f;

        // Closest points of the two lines: v_h on the light, distance h.
        float ab = dot(a, b), sin2 = 1.0f - ab * ab, sin_theta = sqrt(sin2);
        float v_h = (ab * dot(q, a) - dot(q, b)) / sin2, u_h = dot(q, a) + v_h * ab;
        float h = length(q + v_h * b - u_h * a);

        // Marginal: the point v of the light, with density proportional to 1 / sqrt(h^2 + (v - v_h)^2 sin^2).
        float a_0 = asinh(-v_h * sin_theta / h), a_1 = asinh((light.length - v_h) * sin_theta / h);
        float v_hat = h * sinh(a_0 + xi_1 * (a_1 - a_0)) / sin_theta, v = v_h + v_hat;
        float pdf_v = sin_theta / ((a_1 - a_0) * sqrt(h * h + v_hat * v_hat * sin2));

        // Conditional: the point u of the eye segment, uniform in the angle seen from v.
        float3 p = q + v * b;
        float foot = dot(p, a), D = length(p - foot * a);
        float angle_0 = atan(-foot / D), angle_1 = atan((eye.length - foot) / D);
        float u_hat = D * tan(angle_0 + xi_2 * (angle_1 - angle_0)), u = foot + u_hat;
        float pdf_u = D / ((angle_1 - angle_0) * (D * D + u_hat * u_hat));

        float3 d = p - u * a;
        float w2 = dot(d, d), w = sqrt(w2);
        float3 omega = d / w;
        float f = phase(-dot(b, omega), medium.g) * phase(dot(omega, a), medium.g);
        float3 transmittance = COLOURED ? exp(-sigma_t * (u + v + w)) : (float3)(exp(-sigma_t.x * (u + v + w)));
        sum += sigma_s * sigma_s * (float3)(light.r, light.g, light.b) * transmittance * (f / (w2 * pdf_v * pdf_u));
    }
    sums[3 * pixel] = eye.r * sum.x, sums[3 * pixel + 1] = eye.g * sum.y, sums[3 * pixel + 2] = eye.b * sum.z;
}
