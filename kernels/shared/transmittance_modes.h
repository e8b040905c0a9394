/// How the transmittance through density grids is found: a build option (-DTRANSMITTANCE=n), `--transmittance` on the command line.
#ifndef TRANSMITTANCE_MODES_H
#define TRANSMITTANCE_MODES_H

enum {
    TRANSMITTANCE_MARCH = 0,  ///< tables and a jittered march, with an exact correction now and then: unbiased; single contributions can be negative
    TRANSMITTANCE_EXACT = 1,  ///< cell by cell for every pair
};

#ifndef TRANSMITTANCE
#define TRANSMITTANCE TRANSMITTANCE_MARCH
#endif

#endif
