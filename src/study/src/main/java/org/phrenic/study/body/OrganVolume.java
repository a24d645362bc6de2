package org.phrenic.study.body;

import java.util.List;

/**
 * Volume of an organ of the reference adults: masses with contents of ICRP Publication 89 (doi
 * 10.1016/S0146-6453(03)00002-2), over a density.
 *
 * @param name of the structure, such as {@code kidney_R}
 * @param manG mass of the man's, g
 * @param womanG mass of the woman's, g
 * @param density g/ml
 * @param share share of the mass that the virtual bodies have
 */
record OrganVolume(String name, double manG, double womanG, double density, double share) {
    /** Organs whose volume has a reference. */
    static final List<OrganVolume> ALL = List.of(
            whole("liver", 1800, 1400, 1.06),
            whole("heart", 840, 620, 1.06),
            whole("spleen", 150, 130, 1.06),
            whole("kidney_R", 155, 137.5, 1.05),
            whole("kidney_L", 155, 137.5, 1.05),
            whole("pancreas", 140, 120, 1.05),
            whole("gallbladder", 68, 56, 1.03),
            whole("stomach", 400, 370, 1.04),
            new OrganVolume("duodenum", 1000, 880, 1.04, 25.0 / 280),
            new OrganVolume("colon", 525, 530, 1.04, 66.0 / 96));

    private static OrganVolume whole(String name, double manG, double womanG, double density) {
        return new OrganVolume(name, manG, womanG, density, 1);
    }

    /** The reference volume, ml. */
    double referenceMl(boolean woman) {
        return (woman ? womanG : manG) * share / density;
    }
}
