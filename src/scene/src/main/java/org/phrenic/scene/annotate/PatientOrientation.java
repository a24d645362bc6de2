package org.phrenic.scene.annotate;

/**
 * Letters for a direction in the body: L R for the patient's left and right, A P for front and back, S I for above and
 * below.
 */
public final class PatientOrientation {
    /** Below this share of the direction (sine of 22.5 degrees) a letter is left out. */
    private static final double THRESHOLD = 0.3827;

    private static final String POSITIVE = "LPS";
    private static final String NEGATIVE = "RAI";

    private PatientOrientation() {}

    /** Letters of a unit vector in LPS, the strongest first: {@code S}, {@code LA}. */
    public static String letters(double x, double y, double z) {
        double[] v = {x, y, z};
        boolean[] told = new boolean[3];
        StringBuilder letters = new StringBuilder();
        for (int round = 0; round < 3; round++) {
            int strongest = -1;
            for (int i = 0; i < 3; i++) {
                if (!told[i]
                        && Math.abs(v[i]) >= THRESHOLD
                        && (strongest < 0 || Math.abs(v[i]) > Math.abs(v[strongest]))) {
                    strongest = i;
                }
            }
            if (strongest < 0) {
                break;
            }
            told[strongest] = true;
            letters.append((v[strongest] > 0 ? POSITIVE : NEGATIVE).charAt(strongest));
        }
        return letters.toString();
    }
}
