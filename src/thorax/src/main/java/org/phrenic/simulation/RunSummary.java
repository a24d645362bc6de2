package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.simulation.observe.Observation;

/**
 * Summary of a run. For every whole breath it takes the change from the start (end-expiration) to the sample with the
 * lowest domes (end-inspiration), and averages over the breaths. A run without a whole breath, such as a hold or a
 * cough, counts as one breath.
 */
final class RunSummary {
    private final List<Observation> samples;
    private final List<int[]> breaths = new ArrayList<>();

    RunSummary(List<Observation> samples) {
        this.samples = samples;
        int start = 0;
        for (int i = 1; i < samples.size(); i++) {
            if (samples.get(i).get("breath") != samples.get(i - 1).get("breath")) {
                breaths.add(new int[] {start, i});
                start = i;
            }
        }
        if (breaths.isEmpty()) {
            breaths.add(new int[] {0, samples.size() - 1});
        }
    }

    int breathCount() {
        return breaths.size();
    }

    /** Sample of a breath with the lowest mean height of the two domes. */
    private int endInspiration(int[] breath) {
        int best = breath[0];
        for (int i = breath[0]; i <= breath[1]; i++) {
            Observation o = samples.get(i);
            Observation b = samples.get(best);
            if (o.get("dome_right_mm") + o.get("dome_left_mm") < b.get("dome_right_mm") + b.get("dome_left_mm")) {
                best = i;
            }
        }
        return best;
    }

    /** Mean change of a column from end-expiration to end-inspiration over all breaths. */
    private double meanChange(String column) {
        double sum = 0;
        for (int[] breath : breaths) {
            sum += samples.get(endInspiration(breath)).get(column)
                    - samples.get(breath[0]).get(column);
        }
        return sum / breaths.size();
    }

    private double maximum(String column) {
        return samples.stream().mapToDouble(o -> o.get(column)).max().orElse(0);
    }

    /** Largest deviation from the rest shape at the start of a breath or the end of the last, rms mm. */
    private double returnToRest() {
        double worst = 0;
        for (int[] breath : breaths) {
            worst = Math.max(worst, samples.get(breath[0]).get("from_rest_rms_mm"));
        }
        return Math.max(worst, samples.get(breaths.get(breaths.size() - 1)[1]).get("from_rest_rms_mm"));
    }

    /** All values of the summary, in the order of the output. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("breaths", breaths.size());
        map.put("max_rigid_link_error", maximum("rigid_link_error"));
        map.put("rest_return_rms_mm", returnToRest());
        map.put("dome_excursion_right_mm", -meanChange("dome_right_mm"));
        map.put("dome_excursion_left_mm", -meanChange("dome_left_mm"));
        map.put("central_tendon_excursion_mm", -meanChange("central_tendon_mm"));
        for (String place : List.of("anterior", "middle", "posterior", "lateral", "medial")) {
            map.put(place + "_excursion_right_mm", -meanChange(place + "_right_mm"));
            map.put(place + "_excursion_left_mm", -meanChange(place + "_left_mm"));
        }
        map.put("lung_volume_change_ml", meanChange("lung_volume_change_ml"));
        map.put("ap_change_mm", meanChange("ap_change_mm"));
        map.put("transverse_change_mm", meanChange("transverse_change_mm"));
        map.put("sternum_cranial_mm", meanChange("sternum_cranial_mm"));
        map.put("sternum_ventral_mm", meanChange("sternum_ventral_mm"));
        map.put("fibre_shortening_percent", meanChange("fibre_shortening_percent"));
        map.put("liver_si_mm", Math.abs(meanChange("liver_si_mm")));
        map.put("liver_ap_mm", Math.abs(meanChange("liver_ap_mm")));
        map.put("liver_lr_mm", Math.abs(meanChange("liver_lr_mm")));
        return map;
    }
}
