package org.phrenic.access.attempt;

import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.document.OrderedValues;
import org.phrenic.file.Numbers;

/**
 * The greatest loads on a needle in an attempt; see {@link NeedleLoad}.
 *
 * @param peakN greatest axial force in each layer that was met, N, in the order of the layers
 * @param capsulePushMm how far the capsule was pushed, mm
 * @param sideN side load at the capsule, N
 * @param bendingMm how far it bent the needle there, mm
 * @param rotationDeg rotation of the needle by the liver, degrees
 */
public record NeedleLoads(
        Map<String, Double> peakN, double capsulePushMm, double sideN, double bendingMm, double rotationDeg) {
    /** Greatest axial force of all layers, N. */
    public double greatestN() {
        return peakN.values().stream().mapToDouble(n -> n).max().orElse(0);
    }

    /** Text such as "skin 3.8, wall 1.4, capsule 2.9". */
    public String peaks() {
        return peakN.entrySet().stream()
                .map(e -> Numbers.format("%s %.1f", e.getKey(), e.getValue()))
                .collect(Collectors.joining(", "));
    }

    Map<String, Object> toMap() {
        OrderedValues peaks = new OrderedValues();
        peaks.putAll(peakN);
        return new OrderedValues()
                .with("peak_force_n", peaks)
                .with("capsule_push_mm", capsulePushMm)
                .with("side_load_n", sideN)
                .with("bending_mm", bendingMm);
    }
}
