package org.phrenic.simulation.observe;

import java.util.List;

/**
 * Observables at one time. Column names contain the units. Displacements are relative to end-expiration, positive
 * upward. A value that the scene does not have, such as that of an organ that it lacks, is NaN.
 */
public final class Observation {
    /** Column names, in the order of {@link #values}. */
    public static final List<String> COLUMNS = List.of(("time_s breath phase activation pressure_kpa"
                    + " rib_turn dome_right_mm dome_left_mm central_tendon_mm anterior_right_mm"
                    + " middle_right_mm posterior_right_mm anterior_left_mm middle_left_mm posterior_left_mm"
                    + " lateral_right_mm medial_right_mm lateral_left_mm medial_left_mm"
                    + " fibre_shortening_percent lung_volume_change_ml ap_change_mm transverse_change_mm"
                    + " sternum_cranial_mm sternum_ventral_mm liver_si_mm liver_ap_mm liver_lr_mm"
                    + " from_rest_rms_mm rigid_link_error")
            .split(" "));

    private final double[] values;

    public Observation(double[] values) {
        this.values = values;
    }

    /** Value of a column. */
    public double get(String column) {
        return values[COLUMNS.indexOf(column)];
    }

    /** Values of all columns. */
    public double[] values() {
        return values;
    }
}
