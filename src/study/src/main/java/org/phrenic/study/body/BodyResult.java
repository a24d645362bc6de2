package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.file.Numbers;
import org.phrenic.patient.diaphragm.SheetQuality;

/**
 * What the check of a body gave.
 *
 * @param body what was checked
 * @param notInScan what an imported body has that its scan does not show, by kind; empty if there is nothing
 * @param refusal why the body cannot be simulated, one sentence; empty if it can
 * @param sheet quality of the diaphragm at rest; empty if the body lacks what it is measured on, or is refused before
 * @param ribs comparison with the ribs of the body of which the scan was simulated; empty if there is none
 * @param surfaces comparison with the surfaces of that body; empty if there is none
 * @param breaths results in the order of {@link BreathDepth}, those before a refusal
 */
public record BodyResult(
        BodyCase body,
        String notInScan,
        String refusal,
        Optional<SheetQuality> sheet,
        Optional<RibComparison> ribs,
        List<SurfaceMiss> surfaces,
        List<BreathResult> breaths) {
    public BodyResult {
        surfaces = List.copyOf(surfaces);
        breaths = List.copyOf(breaths);
    }

    /** What is beyond the limits, one phrase each. */
    public List<String> faults() {
        if (!refusal.isEmpty()) {
            return List.of(refusal);
        }
        List<String> faults = new ArrayList<>();
        add("outside_cage_maximum_mm", BodyLimits.OUTSIDE_CAGE_MM, "diaphragm outside the cage by", faults);
        breaths.forEach(b -> faults.addAll(b.faults(body.height())));
        return faults;
    }

    private void add(String measure, double limit, String what, List<String> faults) {
        double value = measure(measure);
        if (value > limit) {
            faults.add(Numbers.format("%s %.1f mm", what, value));
        }
    }

    /** A measure of {@link SheetQuality}; NaN if the sheet was not measured. */
    double measure(String key) {
        return sheet.map(quality -> quality.value(key)).orElse(Double.NaN);
    }

    /** Whether the body breathes quietly and deeply to the end. */
    public boolean breathes() {
        return refusal.isEmpty() && breaths.stream().allMatch(b -> b.failure().isEmpty());
    }

    /** {@code within limits}, {@code beyond limits}, {@code diverges} or {@code refused}, with what is beyond. */
    public String status() {
        if (passes()) {
            return "within limits";
        }
        String status = breathes() ? "beyond limits" : refusal.isEmpty() ? "diverges" : "refused";
        return status + ": " + String.join("; ", faults());
    }

    /** Whether the body breathes within all limits. */
    public boolean passes() {
        return faults().isEmpty();
    }

    /** Name of the body. */
    public String name() {
        return body.name();
    }

    /** How the body was made. */
    public String origin() {
        return body.origin();
    }
}
