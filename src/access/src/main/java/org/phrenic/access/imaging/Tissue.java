package org.phrenic.access.imaging;

import java.util.Locale;
import java.util.regex.Pattern;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Surface;

/**
 * A tissue with its physical properties.
 *
 * <p>Densities: ICRU Report 44 (1989) and Woodard and White 1986 (doi 10.1259/0007-1285-59-708-1209); bones are means
 * of cortex and marrow. Mass attenuation coefficients at 40, 60 and 80 keV: Hubbell and Seltzer, NIST Standard
 * Reference Database 126 (doi 10.18434/T4D01F); a bone is cortical bone and soft tissue in the proportion that gives
 * its density.
 *
 * <p>Acoustic impedance: doi 10.3390/s23135942, table A2 (bone, muscle, water); liver 1.65, spleen 1.64, kidney 1.62,
 * blood 1.61 and lung 0.2 to 0.3 MRayl are values of general textbooks; soft tissue is muscle and fat in equal parts;
 * bile and cartilage are density times speed of sound. Attenuation: doi 10.3390/diagnostics13050855, table 4, at 1 MHz,
 * taken as proportional to the frequency; bile as water; cartilage lies between muscle and bone and is an estimate.
 * Echogenicity is not measured: its order is that of textbooks (spleen and liver above kidney cortex and muscle, fluids
 * without echoes), and its level is chosen against the reflection from interfaces.
 */
public enum Tissue {
    SOFT(1.05, 1.54, 0.80, -57),
    LIVER(1.06, 1.65, 0.50, -50),
    /** A lesion of the liver, darker than it, as most metastases are. */
    LESION(1.05, 1.63, 0.60, -58),
    SPLEEN(1.06, 1.64, 0.40, -49),
    KIDNEY(1.05, 1.62, 1.00, -54),
    HEART(1.06, 1.64, 0.52, -55),
    BLOOD(1.06, 1.61, 0.15, -85),
    /** Stands for urine in the bladder and the fluid of a cyst as well. */
    BILE(1.02, 1.56, 0.0022, -110),
    MUSCLE(1.05, 1.68, 0.96, -55),
    /**
     * At end-expiration: 1.2 kg of tissue and blood, of 1.05 g/cm3, and 3.3 l of air (ICRP Publication 89) make an
     * organ of 4.4 l. Tissue and blood stay in the lung when its volume changes.
     */
    LUNG(0.27, 0.26, 40, -60),
    GAS(0.001, 0.0004, 7.5, -140),
    /** Water, and the gel between probe and skin. */
    WATER(1.00, 1.46, 0.0022, -140),
    CARTILAGE(1.10, 1.85, 5, -62),
    RIB(1.41, 6.50, 15, -55),
    VERTEBRA(1.33, 6.50, 15, -55),
    STERNUM(1.25, 6.50, 15, -55);

    private static final Pattern CYST = Pattern.compile("(.*_)?cysts?(_.*)?");

    private static final double CORTICAL_DENSITY = 1.92;
    private static final double SOFT_DENSITY = 1.05;
    /** Photon energies of the tables, keV. */
    private static final double[] ENERGIES_KEV = {40, 60, 80};

    private static final double[] SOFT_CM2_PER_G = {0.2688, 0.2048, 0.1823};
    private static final double[] CORTICAL_CM2_PER_G = {0.6655, 0.3148, 0.2229};

    private final double density;
    private final double impedance;
    private final double attenuation;
    private final double echogenicity;

    /**
     * @param density g/cm3
     * @param impedance acoustic, MRayl
     * @param attenuation of ultrasound, dB/cm at 1 MHz
     * @param echogenicity dB
     */
    Tissue(double density, double impedance, double attenuation, double echogenicity) {
        this.density = density;
        this.impedance = impedance;
        this.attenuation = attenuation;
        this.echogenicity = echogenicity;
    }

    /** Acoustic impedance, MRayl. */
    public double impedance() {
        return impedance;
    }

    /** Attenuation of ultrasound one way, dB/cm at 1 MHz; proportional to the frequency. */
    public double attenuationDbPerCmMhz() {
        return attenuation;
    }

    /** Mean intensity of the echoes from within, dB of the echo of a perfect plane mirror at a right angle. */
    public double echogenicityDb() {
        return echogenicity;
    }

    /**
     * Ratio of the reflected to the incident amplitude of ultrasound at the plane boundary to another tissue,
     * {@code (Z2 - Z1) / (Z2 + Z1)}. Its square is the ratio of intensities.
     */
    public double reflectionTo(Tissue other) {
        return (other.impedance - impedance) / (other.impedance + impedance);
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

    /** Interpolates a table over the energies of the tables in the logarithms of both. */
    static double interpolate(double[] table, double energyKev) {
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
            case SKIN, PLEURA -> SOFT;
            case LESION -> LESION;
            case ORGAN, OTHER -> ofOrgan(name.toLowerCase(Locale.ROOT));
        };
    }

    private static Tissue ofOrgan(String name) {
        if (name.contains("trachea") || name.contains("bowel_gas")) {
            return GAS;
        }
        if (name.contains("gall")
                || name.contains("bladder")
                || CYST.matcher(name).matches()) {
            return BILE;
        }
        if (name.contains("spleen")) {
            return SPLEEN;
        }
        if (name.contains("kidney")) {
            return KIDNEY;
        }
        return name.contains("heart") ? HEART : SOFT;
    }
}
