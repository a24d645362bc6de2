package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.simulation.observe.Observation;

/**
 * Summary of a run. For every whole breath it takes the change from the start (end-expiration) to the sample with the
 * lowest domes (end-inspiration), and averages over the breaths. A breath that another preset or trace cut short is not
 * a whole one. A run without a whole breath, such as a hold or a cough, counts as one breath.
 *
 * <p>Beside each change it gives the peak-to-peak value: the largest minus the smallest value within a breath, averaged
 * over the breaths. The two differ where a part of the body lags behind the domes.
 */
public final class RunSummary {
    private static final String PEAK_TO_PEAK = "_peak_to_peak";
    private static final List<String> PLACES = List.of("anterior", "middle", "posterior", "lateral", "medial");

    private final List<Observation> samples;
    private final List<int[]> breaths = new ArrayList<>();

    /**
     * @param samples in the order of time; a column of NaN has no value
     * @param cutShortS times at which another breathing pattern ended a breath before its end, s
     */
    RunSummary(List<Observation> samples, List<Double> cutShortS) {
        this.samples = samples;
        int start = 0;
        for (int i = 1; i < samples.size(); i++) {
            double begun = samples.get(i).get("breath") - samples.get(i - 1).get("breath");
            if (begun != 0) {
                double from = samples.get(i - 1).get("time_s");
                double to = samples.get(i).get("time_s");
                long cut = cutShortS.stream().filter(s -> s >= from && s < to).count();
                // The first of several breaths that end between two samples is whole if not all of them are cut short.
                if (cut < Math.abs(begun)) {
                    breaths.add(new int[] {start, i});
                }
                start = i;
            }
        }
        if (breaths.isEmpty()) {
            breaths.add(new int[] {0, samples.size() - 1});
        }
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

    /** Mean over all breaths of the largest minus the smallest value of a column within a breath. */
    private double meanPeakToPeak(String column) {
        double sum = 0;
        for (int[] breath : breaths) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = breath[0]; i <= breath[1]; i++) {
                double value = samples.get(i).get(column);
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
            sum += high - low;
        }
        return sum / breaths.size();
    }

    /** Key of the peak-to-peak value beside that of a change, such as {@code liver_si_peak_to_peak_mm}. */
    public static String peakToPeakKey(String key) {
        int unit = key.lastIndexOf('_');
        return unit < 0 ? key + PEAK_TO_PEAK : key.substring(0, unit) + PEAK_TO_PEAK + key.substring(unit);
    }

    /** Column of the observables that each change is taken from, by the key of the change. */
    private static Map<String, String> columns() {
        Map<String, String> columns = new LinkedHashMap<>();
        columns.put("dome_excursion_right_mm", "dome_right_mm");
        columns.put("dome_excursion_left_mm", "dome_left_mm");
        columns.put("central_tendon_excursion_mm", "central_tendon_mm");
        for (String place : PLACES) {
            columns.put(place + "_excursion_right_mm", place + "_right_mm");
            columns.put(place + "_excursion_left_mm", place + "_left_mm");
        }
        List.of(
                        "lung_volume_change_ml",
                        "ap_change_mm",
                        "transverse_change_mm",
                        "sternum_cranial_mm",
                        "sternum_ventral_mm",
                        "fibre_shortening_percent",
                        "liver_si_mm",
                        "liver_ap_mm",
                        "liver_lr_mm")
                .forEach(key -> columns.put(key, key));
        return columns;
    }

    /** All values of the summary, in the order of the output, without those that the scene does not have. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("breaths", breaths.size());
        map.put("max_rigid_link_error", maximum("rigid_link_error"));
        map.put("rest_return_rms_mm", returnToRest());
        Map<String, String> columns = columns();
        columns.forEach((key, column) -> {
            double change = meanChange(column);
            map.put(key, key.contains("_excursion") ? -change : key.startsWith("liver_") ? Math.abs(change) : change);
        });
        columns.forEach((key, column) -> map.put(peakToPeakKey(key), meanPeakToPeak(column)));
        map.values().removeIf(value -> value instanceof Double number && Double.isNaN(number));
        return map;
    }
}
