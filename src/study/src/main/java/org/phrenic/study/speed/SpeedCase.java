package org.phrenic.study.speed;

import org.phrenic.anatomy.Resolution;

/** The four columns of the paper's table 1, which differ in the active parts of the model. */
public enum SpeedCase {
    HETEROGENEOUS("heterogeneous, all forces", "tensegrity=true", 8.13, 10.41, 12.79),
    HOMOGENEOUS("homogeneous, all forces", "tensegrity=false", 8.56, 10.69, 13.07),
    RIBS_ONLY("rib motion only", "muscle=false", 8.24, 10.93, 13.27),
    MUSCLE_ONLY("diaphragm muscle only", "ribs=false", 9.68, 11.76, 14.70);

    private final String label;
    private final String setting;
    private final double high;
    private final double medium;
    private final double low;

    SpeedCase(String label, String setting, double high, double medium, double low) {
        this.label = label;
        this.setting = setting;
        this.high = high;
        this.medium = medium;
        this.low = low;
    }

    /** Column heading. */
    public String label() {
        return label;
    }

    /** Scenario assignment that selects this case. */
    String setting() {
        return setting;
    }

    /** Speed printed in the paper, iterations/s. */
    public double publishedStepsPerS(Resolution resolution) {
        return switch (resolution) {
            case HIGH -> high;
            case MEDIUM -> medium;
            case LOW -> low;
        };
    }
}
