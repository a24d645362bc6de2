package org.phrenic.mesh.io.raster;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Even lines from one to another, as those of pixels, found from the corners of contours.
 *
 * @param low the first one, mm
 * @param high the last one, mm
 * @param steps their number less one
 */
public record EvenLines(double low, double high, double steps) {
    /** Numbers that differ by less are one, mm. */
    public static final double ROUNDING = 0.02;
    /** Greatest share of contours that are no outlines among those of masks. */
    public static final double MAX_DRAWN = 0.05;

    /** Pixels of masks, mm, and the least number of lines on which corners lie. */
    private static final double MIN_PIXEL = 0.3;

    private static final double MAX_PIXEL = 3;
    private static final int MIN_LINES = 6;
    private static final int MAX_LINES = 1024;
    /** Share of the pixel by which corners may lie beside lines that others made known. */
    private static final double NEAR = 0.125;

    /** The lines on which nearly all of these lists of sorted numbers lie; empty if there are none. */
    public static Optional<EvenLines> ofMost(List<double[]> all) {
        double[] least = all.stream()
                .map(EvenLines::gaps)
                .filter(gaps -> gaps.length > 0)
                .mapToDouble(gaps -> gaps[0])
                .sorted()
                .toArray();
        double pixel = least.length == 0 ? 0 : least[(int) (MAX_DRAWN * least.length)];
        if (!(pixel >= MIN_PIXEL && pixel <= MAX_PIXEL)) {
            return Optional.empty();
        }
        Optional<EvenLines> longest = all.stream()
                .sorted(Comparator.comparingInt(sorted -> -gaps(sorted).length))
                .flatMap(sorted -> EvenLines.of(sorted, pixel).stream())
                .findFirst();
        if (longest.isEmpty()) {
            return Optional.empty();
        }
        EvenLines from = longest.get();
        EvenLines lines = from;
        for (double[] sorted :
                all.stream().sorted(Comparator.comparingDouble(from::beyond)).toList()) {
            lines = lines.hold(sorted, NEAR * pixel) ? lines.to(sorted) : lines;
        }
        EvenLines found = lines;
        long used = all.stream()
                .flatMapToDouble(Arrays::stream)
                .map(at -> Math.rint(found.index(at)))
                .distinct()
                .count();
        return used >= MIN_LINES && found.steps() < MAX_LINES ? Optional.of(found) : Optional.empty();
    }

    /** Those on which all of these numbers lie; empty if there are none. */
    static Optional<EvenLines> of(double[] sorted, double rounded) {
        double distance = rounded;
        double along = 0;
        double steps = 0;
        for (double gap : gaps(sorted)) {
            along += gap;
            steps += Math.rint(gap / distance);
            distance = along / steps;
        }
        EvenLines lines = new EvenLines(sorted[0], sorted[sorted.length - 1], steps);
        return steps > 0 && lines.hold(sorted, ROUNDING) ? Optional.of(lines) : Optional.empty();
    }

    /** Distance of two lines, mm. */
    public double distance() {
        return (high - low) / steps;
    }

    /** Number of lines from the first one; whole on a line. */
    public double index(double at) {
        double index = (at - low) / distance();
        return Math.abs(index - Math.rint(index)) * distance() <= ROUNDING ? Math.rint(index) : index;
    }

    boolean hold(double[] numbers, double tolerance) {
        return Arrays.stream(numbers)
                .map(at -> (at - low) / distance())
                .allMatch(index -> Math.abs(index - Math.rint(index)) * distance() <= tolerance);
    }

    /** How far numbers reach beyond the lines. */
    double beyond(double[] sorted) {
        return Math.max(low - sorted[0], sorted[sorted.length - 1] - high);
    }

    /** The lines up to those of further numbers, which make their distance more exact. */
    EvenLines to(double[] sorted) {
        double least = Math.min(low, sorted[0]);
        double greatest = Math.max(high, sorted[sorted.length - 1]);
        return new EvenLines(least, greatest, Math.rint((greatest - least) / distance()));
    }

    /** The gaps between numbers, from the smallest to the largest. */
    private static double[] gaps(double[] sorted) {
        return IntStream.range(1, sorted.length)
                .mapToDouble(i -> sorted[i] - sorted[i - 1])
                .filter(gap -> gap > ROUNDING)
                .sorted()
                .toArray();
    }
}
