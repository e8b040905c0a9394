/// One of the lights that a group of 16 eyes connects to, and what its contribution is multiplied by: 1 / (how often it is chosen on average); 8 bytes.
#ifndef LIGHT_CHOICE_H
#define LIGHT_CHOICE_H

typedef struct {
    uint light;
    float weight;
} LightChoice;
LAYOUT(LightChoice, 8)

/// Build option (-DSELECTION=n): 0: every eye connects to all lights; 1: to those that select_lights chose for its group.
#ifndef SELECTION
#define SELECTION 0
#endif

#endif
