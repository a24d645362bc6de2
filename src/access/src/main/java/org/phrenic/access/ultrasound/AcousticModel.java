package org.phrenic.access.ultrasound;

import java.util.EnumMap;
import java.util.Map;
import org.phrenic.access.imaging.Tissue;

/**
 * Reflection and attenuation of ultrasound at one frequency, as ratios of amplitudes. At a boundary the reflected
 * intensity is {@code ((Z2 - Z1) / (Z2 + Z1))^2 cos^n} of the angle of incidence, with n = {@value #SPECULAR_EXPONENT};
 * after Wein et al. 2008 (doi 10.1016/j.media.2008.06.006). Liver, spleen, kidney, gall bladder and diaphragm, and the
 * branches of the portal vein in the liver, are coated by {@value #COAT_MM} mm of connective tissue, whose two faces
 * reflect {@code r1 + r2 exp(-2 i k t)}.
 */
final class AcousticModel {
    static final int SPECULAR_EXPONENT = 6;
    private static final double COAT_MM = 0.1;
    /** Density 1.1 g/cm3 times the speed, MRayl. */
    private static final double COAT_IMPEDANCE = 1.87;

    private static final double COAT_SPEED_MM_PER_US = 1.7;
    private static final double NEPER_PER_DB = StrictMath.log(10) / 20;

    private final Map<Tissue, Double> nepersPerMm = new EnumMap<>(Tissue.class);
    private final Map<Tissue, Double> backscatter = new EnumMap<>(Tissue.class);
    private final double coatPhase;

    AcousticModel(double frequencyMhz) {
        for (Tissue tissue : Tissue.values()) {
            double dbPerMm = 2 * tissue.attenuationDbPerCmMhz() * frequencyMhz / 10;
            nepersPerMm.put(tissue, dbPerMm * NEPER_PER_DB);
            backscatter.put(tissue, StrictMath.pow(10, tissue.echogenicityDb() / 20));
        }
        coatPhase = StrictMath.cos(4 * Math.PI * frequencyMhz / COAT_SPEED_MM_PER_US * COAT_MM);
    }

    /** Attenuation of an echo's amplitude on the way there and back, 1/mm of depth. */
    double nepersPerMm(Tissue tissue) {
        return nepersPerMm.get(tissue);
    }

    /** Root mean square amplitude of the echoes from within a tissue. */
    double backscatter(Tissue tissue) {
        return backscatter.get(tissue);
    }

    private static boolean isCoated(Tissue tissue) {
        return switch (tissue) {
            case LIVER, SPLEEN, KIDNEY, BILE -> true;
            default -> false;
        };
    }

    /** Whether the boundary is the border of a lesion or of blood in the liver, which has no capsule. */
    private static boolean isWithinLiver(Tissue one, Tissue other) {
        return one == Tissue.LIVER && (other == Tissue.LESION || other == Tissue.BLOOD);
    }

    /**
     * Reflected amplitude at a right angle, 0 to 1.
     *
     * @param coat whether the boundary is a sheet of connective tissue whatever lies beside it
     */
    double reflection(Tissue from, Tissue to, boolean coat) {
        double plain = from.reflectionTo(to);
        boolean within = isWithinLiver(from, to) || isWithinLiver(to, from);
        if (!coat && (within || !(from != to && (isCoated(from) || isCoated(to))))) {
            return Math.abs(plain);
        }
        double in = (COAT_IMPEDANCE - from.impedance()) / (COAT_IMPEDANCE + from.impedance());
        double out = (to.impedance() - COAT_IMPEDANCE) / (to.impedance() + COAT_IMPEDANCE);
        return Math.min(1, Math.sqrt(in * in + out * out + 2 * in * out * coatPhase));
    }

    /** Factor of the reflected amplitude at an angle of incidence with this cosine. */
    static double specular(double cosine) {
        double factor = 1;
        for (int i = 0; i < SPECULAR_EXPONENT / 2; i++) {
            factor *= cosine;
        }
        return factor;
    }
}
