package org.phrenic.access.imaging;

import java.util.Locale;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Surface;

/**
 * A tissue with its physical properties.
 *
 * <p>Densities: ICRU Report 44 (1989) and Woodard and White 1986 (doi 10.1259/0007-1285-59-708-1209); bones are means
 * of cortex and marrow. Mass attenuation coefficients at 40, 60 and 80 keV: Hubbell and Seltzer, NIST Standard
 * Reference Database 126 (doi 10.18434/T4D01F); a bone is cortical bone and soft tissue in the proportion that gives
 * its density.
 */
public enum Tissue {
    SOFT(1.05),
    LIVER(1.06),
    SPLEEN(1.06),
    KIDNEY(1.05),
    HEART(1.06),
    BLOOD(1.06),
    BILE(1.02),
    MUSCLE(1.05),
    /**
     * At end-expiration: 1.2 kg of tissue and blood (ICRP Publication 89) in 3.3 l. They stay in the lung when its
     * volume changes.
     */
    LUNG(0.36),
    GAS(0.001),
    CARTILAGE(1.10),
    RIB(1.41),
    VERTEBRA(1.33),
    STERNUM(1.25);

    private static final double CORTICAL_DENSITY = 1.92;
    private static final double SOFT_DENSITY = 1.05;
    /** Photon energies of the tables, keV. */
    private static final double[] ENERGIES_KEV = {40, 60, 80};

    private static final double[] SOFT_CM2_PER_G = {0.2688, 0.2048, 0.1823};
    private static final double[] CORTICAL_CM2_PER_G = {0.6655, 0.3148, 0.2229};

    private final double density;

    Tissue(double density) {
        this.density = density;
    }

    /** Density, g/cm3. */
    public double density() {
        return density;
    }

    /**
     * Linear attenuation coefficient, 1/mm: mass attenuation times density. Between the energies of the tables it is
     * interpolated in the logarithms of both.
     *
     * @param energyKev photon energy, within 40 to 80 keV
     */
    public double attenuationPerMm(double energyKev) {
        double cortical = isBone() ? (density - SOFT_DENSITY) / (CORTICAL_DENSITY - SOFT_DENSITY) : 0;
        double soft = isBone() ? SOFT_DENSITY * (1 - cortical) : density;
        double perCm = soft * interpolate(SOFT_CM2_PER_G, energyKev)
                + cortical * CORTICAL_DENSITY * interpolate(CORTICAL_CM2_PER_G, energyKev);
        return perCm / 10;
    }

    private boolean isBone() {
        return compareTo(RIB) >= 0;
    }

    private static double interpolate(double[] table, double energyKev) {
        if (!(energyKev >= ENERGIES_KEV[0] && energyKev <= ENERGIES_KEV[ENERGIES_KEV.length - 1])) {
            throw new IllegalArgumentException("photon energy: found " + energyKev + " keV, expected 40 to 80");
        }
        int i = energyKev < ENERGIES_KEV[1] ? 0 : 1;
        double share =
                StrictMath.log(energyKev / ENERGIES_KEV[i]) / StrictMath.log(ENERGIES_KEV[i + 1] / ENERGIES_KEV[i]);
        return table[i] * StrictMath.pow(table[i + 1] / table[i], share);
    }

    /** The tissue inside a surface. Organs are told by their names; the skin encloses {@link #SOFT} tissue. */
    public static Tissue of(Surface surface) {
        return of(surface.kind(), surface.name());
    }

    /** The tissue of a structure of a kind and name. */
    public static Tissue of(StructureKind kind, String name) {
        return switch (kind) {
            case RIB, BONE -> RIB;
            case COSTAL_CARTILAGE, DISC -> CARTILAGE;
            case STERNUM -> STERNUM;
            case VERTEBRA -> VERTEBRA;
            case LUNG -> LUNG;
            case LIVER -> LIVER;
            case VESSEL -> BLOOD;
            case MUSCLE, DIAPHRAGM -> MUSCLE;
            case SKIN, LESION -> SOFT;
            case ORGAN, OTHER -> ofOrgan(name.toLowerCase(Locale.ROOT));
        };
    }

    private static Tissue ofOrgan(String name) {
        if (name.contains("trachea") || name.contains("bowel_gas")) {
            return GAS;
        }
        if (name.contains("spleen")) {
            return SPLEEN;
        }
        if (name.contains("kidney")) {
            return KIDNEY;
        }
        if (name.contains("heart")) {
            return HEART;
        }
        return name.contains("gall") ? BILE : SOFT;
    }
}
