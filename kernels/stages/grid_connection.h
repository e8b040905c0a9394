// Connections through density grids: two ways of drawing their places, and the transmittance of their three legs (kernels/README.md, section 13).
#ifndef GRID_CONNECTION_H
#define GRID_CONNECTION_H

/// The exact value is computed for one in so many pairs of a group of eyes, and counts as often.
#define CORRECTION_PERIOD 32u

/// Salts of choices; any numbers that differ.
#define SALT_CORRECTION 0x51ed270bu
#define SALT_STRATEGY 0x2545f491u
#define SALT_JITTER 0x68bc21ebu

/// Chance that a pair is drawn from the tables: grows from this optical depth of both rays together, by so much per unit, up to a most.
#define MATTER_FROM 1.0f
#define MATTER_SLOPE 0.1f
#define MATTER_MOST 0.5f

/// 32 random bits that all eyes of the group of EYE_GROUP share for a pair.
static inline uint shared_bits(const EyeGroup* around, uint counter, uint salt) { return mix_scalar(around->key + mix_scalar(counter ^ salt)); }

static inline OpticalTable table_of_light(Surroundings s, uint number)
{
    OpticalTable t = {s.light_tables + (size_t)number * TABLE_FLOATS, 1u, (bits)(0u)};
    return t;
}
static inline real3 sigma_t_of(MediumRecord m) { return make_real3((real)m.sigma_t_r, (real)m.sigma_t_g, (real)m.sigma_t_b); }

/// Short lights divide by the chance of getting there: what is left of their transmittance is even.
static inline uint lies_even(Light light) { return SHORT_LIGHTS && light.is_short != 0u ? 1u : 0u; }

/// Mean grey optical depth of a light.
static inline float depth_of_light(Surroundings s, Light light, uint number)
{
    MediumRecord m = medium_of(s, light);
    __global const float* end = s.light_tables + (size_t)number * TABLE_FLOATS + TABLE_INTERVALS;
    float red = end[0], green = COLOURED_GRIDS ? end[TABLE_NODES] : red, blue = COLOURED_GRIDS ? end[2u * TABLE_NODES] : red;
    return (m.sigma_t_r * red + m.sigma_t_g * green + m.sigma_t_b * blue) / 3.0f;
}

/// Chance that a pair is drawn from the tables, from the optical depths of both rays.
static inline float share_of_matter(const EyeGroup* around, Surroundings s, Light light, uint number)
{
    if (medium_of(s, light).density_grid == NO_GRID) return 0.0f;
    float depth = depth_of_light(s, light, number);
    if (!(depth > 0.0f)) return 0.0f;
    if (EYES_HAVE_TABLES && !(around->depth > 0.0f)) return 0.0f;
    return fmin(MATTER_SLOPE * fmax(depth + around->depth - MATTER_FROM, 0.0f), MATTER_MOST);
}

/// Is this pair drawn from the tables?
static inline bool draws_matter(const EyeGroup* around, Surroundings s, Light light, uint number, uint counter)
{
    float share = share_of_matter(around, s, light, number);
    return share > 0.0f && (float)(shared_bits(around, counter, SALT_STRATEGY) >> 8) * 0x1p-24f < share;
}

static inline real matter_on_light(Surroundings s, Light light, uint number, real xi)
{
    return sample_matter(table_of_light(s, number), sigma_t_of(medium_of(s, light)), (real)light.length, lies_even(light), xi);
}

static inline OnBoth share_with_matter(Eye eye, const EyeGroup* around, Surroundings s, Light light, uint number, OnBoth at, Passed to_eye, Passed to_light)
{
    float share = share_of_matter(around, s, light, number);
    if (!(share > 0.0f)) return at;
    real other = pdf_matter(to_light, sigma_t_of(medium_of(s, light)), (real)depth_of_light(s, light, number), lies_even(light));
    return share_pair(eye, &around->table, light, at, to_eye, other, (real)share);
}

/// What lies along the light up to a place, exactly: from its table, with the interval of the place walked cell by cell.
static inline Matter exact_matter_on_light(Surroundings s, MediumRecord medium, Light light, OpticalTable table, real v)
{
    real3 origin = light_origin(light), direction = light_direction(light);
    TableNode node = node_below(table, v, (real)light.length);
    real3 way = scale3(direction, v - node.x);
    Matter m = {add3(node.path, exact_path(s, medium, along3(origin, node.x, direction), way, v - node.x, R(0.0), R(1.0))),
                scattering_at(s, medium, along3(origin, v, direction), 1u)};
    return m;
}

/// The connection with all that grids have a part in.
static inline Connection with_matter(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, Matter on_eye, Matter on_light, real jitter,
                                     uint exact)
{
    MediumRecord medium = medium_of(s, light);
    Connection c = connect_eye(eye, light, medium, phase_tables(s), at, on_eye, on_light);
    Leg leg = {c.from, sub3(c.to, c.from), c.length, jitter, exact};
    c.radiance = mul3(c.radiance, transmittance3(leg_depth(&around->facing, s, medium, leg)));
    return c;
}
static inline Connection exactly(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, OpticalTable table)
{
    return with_matter(eye, around, light, s, at, exact_matter_at_eye(s, &around->media, eye, &around->table, at),
                       exact_matter_on_light(s, medium_of(s, light), light, table, at.v), R(0.0), 1u);
}

/// Approximate transmittances and densities, and for some pairs approximate + CORRECTION_PERIOD (exact - approximate): unbiased whatever the approximation.
static inline Connection connect_in_grids(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, uint number, uint counter)
{
    MediumRecord medium = medium_of(s, light);
    OpticalTable table = table_of_light(s, number);
    Passed to_light = passed(table, at.v, (real)light.length), to_eye = passed_to_eye(eye, &around->table, at);
    at = share_with_matter(eye, around, s, light, number, at, to_eye, to_light);
    if (TRANSMITTANCE == TRANSMITTANCE_EXACT) return exactly(eye, around, light, s, at, table);
    Matter on_eye = matter_at_eye(s, &around->media, eye, at, to_eye.path);
    Matter on_light = {to_light.path, scattering_at(s, medium, along3(light_origin(light), at.v, light_direction(light)), 0u)};
    Connection c = with_matter(eye, around, light, s, at, on_eye, on_light, random2(eye.key, counter ^ SALT_JITTER).first, 0u);
    if (shared_bits(around, counter, SALT_CORRECTION) % CORRECTION_PERIOD == 0u) {
        real3 error = sub3(exactly(eye, around, light, s, at, table).radiance, c.radiance);
        c.radiance = along3(c.radiance, (real)(float)CORRECTION_PERIOD, error);
    }
    return c;
}

#endif
