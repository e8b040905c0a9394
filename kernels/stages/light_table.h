// What lies along lights, from their tables.
#ifndef LIGHT_TABLE_H
#define LIGHT_TABLE_H

PURE OpticalTable table_of_light(Surroundings s, Light light, uint number)
{
    float per_length = (float)TABLE_INTERVALS / fmax(light_length(light), 0x1p-126f);
    OpticalTable t = {s.light_tables + (size_t)number * TABLE_FLOATS, 1u, (bits)(0u), (real)per_length};
    return t;
}
PURE real3 sigma_t_of(MediumRecord m) { return make_real3((real)m.sigma_t_r, (real)m.sigma_t_g, (real)m.sigma_t_b); }

/// What lies along the light up to a place, exactly: from its table, with the interval of the place walked cell by cell. A point has it in its power.
PURE Matter exact_matter_on_light(Surroundings s, MediumRecord medium, Light light, uint number, real v)
{
    if (!LIGHT_IS_LINE) return even_matter(R(0.0));
    OpticalTable table = table_of_light(s, light, number);
    real3 origin = light_origin(light), direction = light_direction(light);
    TableNode node = node_below(table, v, (real)light_length(light));
    real3 way = scale3(direction, v - node.x);
    Matter m = {add3(node.path, exact_path(s, medium, along3(origin, node.x, direction), way, v - node.x, R(0.0), R(1.0))),
                scattering_at(s, medium, along3(origin, v, direction))};
    return m;
}

#endif
