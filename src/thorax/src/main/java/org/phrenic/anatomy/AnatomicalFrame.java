package org.phrenic.anatomy;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;

/**
 * The anatomical axes and length unit of a thorax, and the transform to LPS millimetres. Axes are three letters, the
 * directions of +x, +y and +z (L or R, P or A, S or I). Unstated axes are detected from the structures: spine and
 * sternum give the antero-posterior axis, the rib levels the vertical axis, the sides in the names the transverse axis.
 *
 * @param axes three letters, such as {@code LSA}
 * @param millimetresPerUnit length of a unit, mm
 */
public record AnatomicalFrame(String axes, double millimetresPerUnit) {
    /** Minimum width of a rib cage, mm, of an adult or a child. A smaller one was given in cm or m. */
    private static final double MIN_CAGE_WIDTH_MM = 100;

    private static final double MAX_CAGE_WIDTH_MM = 500;
    /** Extent of a part of a trunk that is worth completing, mm: from a liver to a whole trunk. */
    private static final double MIN_PART_MM = 80;

    private static final double MAX_PART_MM = 1200;
    /** Length that no person has, mm. */
    private static final double LONGEST_MM = 3000;
    /** Ribs below it are as short as their heads are apart, where the border of a scan cuts them. */
    private static final int LAST_WIDE_RIB = 10;

    private static final String UNKNOWN_AXES = "???";
    private static final String DIRECTIONS = "LRPASI";

    public AnatomicalFrame {
        axes = axes.toUpperCase(Locale.ROOT);
        if (axes.length() != 3 || determinant(axes) == 0) {
            throw new IllegalArgumentException("axes: found '" + axes
                    + "', expected three letters, one each of L or R, P or A, S or I, such as LPS, RAS or LSA");
        }
        if (determinant(axes) < 0) {
            throw new IllegalArgumentException("axes: found '" + axes
                    + "', a left-handed frame in which the body is mirrored; expected a right-handed one such as LPS");
        }
    }

    private static int axis(char letter) {
        int place = DIRECTIONS.indexOf(letter);
        return place < 0 ? -1 : place / 2;
    }

    private static int sign(char letter) {
        return DIRECTIONS.indexOf(letter) % 2 == 0 ? 1 : -1;
    }

    private static int determinant(String axes) {
        int a = axis(axes.charAt(0));
        int b = axis(axes.charAt(1));
        int c = axis(axes.charAt(2));
        if (a < 0 || b < 0 || c < 0 || a == b || b == c || a == c) {
            return 0;
        }
        int even = (a + 1) % 3 == b ? 1 : -1;
        return even * sign(axes.charAt(0)) * sign(axes.charAt(1)) * sign(axes.charAt(2));
    }

    /** Transforms a mesh to LPS and mm. The frame is right-handed, so triangles keep their orientation. */
    public TriangleMesh toLps(TriangleMesh mesh) {
        double[] given = mesh.positions();
        double[] out = new double[given.length];
        for (int from = 0; from < 3; from++) {
            char letter = axes.charAt(from);
            int to = axis(letter) - from;
            double scale = sign(letter) * millimetresPerUnit;
            for (int i = from; i < given.length; i += 3) {
                out[i + to] = scale * given[i];
            }
        }
        return mesh.withPositions(out);
    }

    /**
     * Creates a frame from stated axes; the unit follows from the width of the rib cage.
     *
     * @throws IllegalArgumentException if the axes are invalid, or there are no ribs to determine the unit
     */
    public static AnatomicalFrame ofStatedAxes(String axes, List<Structure> structures) {
        AnatomicalFrame frame = new AnatomicalFrame(axes, 1);
        if (structures.stream().noneMatch(s -> s.kind() == StructureKind.RIB)) {
            throw new IllegalArgumentException("units: not stated, and there are no ribs to read them off;"
                    + " expected a line 'units: mm' in thorax.yaml");
        }
        return new AnatomicalFrame(frame.axes, detectUnit(structures, frame.axes));
    }

    /**
     * Detects axes and unit from the structures.
     *
     * @throws IllegalArgumentException if there are too few structures, or the sides in their names are mirrored
     */
    public static AnatomicalFrame detect(List<Structure> structures) {
        String axes = detectedAxes(structures);
        if (axes.equals(UNKNOWN_AXES)) {
            throw new IllegalArgumentException(
                    "axes: not stated, and ribs of both sides, vertebrae and sternum are needed to read them off;"
                            + " expected a line 'axes: ...' in thorax.yaml");
        }
        if (determinant(axes) == 0) {
            throw new IllegalArgumentException("axes: not stated, and the structures' places give '" + axes
                    + "', which is no frame; expected a line 'axes: ...' in thorax.yaml");
        }
        requireNotMirrored(axes);
        return new AnatomicalFrame(axes, detectUnit(structures, axes));
    }

    private static void requireNotMirrored(String axes) {
        if (determinant(axes) < 0) {
            throw new IllegalArgumentException("axes: the structures' names and places give '" + axes
                    + "', a mirrored body; left and right are exchanged somewhere");
        }
    }

    /**
     * Detects axes from any structures. Where they leave an axis open, the axes are LPS or RAS, the conventions of
     * scans, as far as the sides in the names agree with one of them; LPS if with both.
     *
     * @throws IllegalArgumentException if the sides and levels in the names agree with neither, or the sides are
     *     mirrored
     */
    static String axesOfPart(List<Structure> structures) {
        String seen = detectedAxes(structures);
        requireNotMirrored(seen);
        return determinant(seen) > 0
                ? seen
                : Stream.of("LPS", "RAS")
                        .filter(known -> agrees(structures, known))
                        .findFirst()
                        .orElseThrow(() -> new IllegalArgumentException("axes: not stated, and the places of the"
                                + " structures agree with neither LPS nor RAS; expected a line 'axes: ...' in"
                                + " thorax.yaml"));
    }

    /**
     * Detects the length of a unit, mm, from the width of the rib cage. Where ribs 1 to 10 lack on a side, the cage
     * fits no unit, or no person is as long as the structures in its unit, the extent of all structures tells.
     *
     * @param axes of the structures
     * @throws IllegalArgumentException if the axes are invalid, or the structures are too small or too large for a part
     *     of a trunk in any unit
     */
    static double unitOfPart(String axes, List<Structure> structures) {
        String valid = new AnatomicalFrame(axes, 1).axes;
        boolean bothSides = Stream.of(Side.RIGHT, Side.LEFT)
                .allMatch(side -> centre(structures, StructureKind.RIB, side, 1, LAST_WIDE_RIB) != null);
        OptionalDouble ofCage = bothSides ? unitOfCage(structures, valid) : OptionalDouble.empty();
        return ofCage.isPresent() && ofCage.getAsDouble() * extent(structures) <= LONGEST_MM
                ? ofCage.getAsDouble()
                : unitOfExtent(structures);
    }

    private static double extent(List<Structure> structures) {
        return IntStream.range(0, 3)
                .mapToDouble(axis -> extent(structures, axis))
                .max()
                .orElseThrow();
    }

    private static double unitOfExtent(List<Structure> structures) {
        double extent = extent(structures);
        return unit(extent, MIN_PART_MM, MAX_PART_MM)
                .orElseThrow(() -> new IllegalArgumentException(Numbers.format(
                        "units: found structures over %.4g units, expected 80 to 1200 mm (or that in cm or m)",
                        extent)));
    }

    /** Whether right and left, upper and lower structures lie as the axes say, as far as there are any. */
    private static boolean agrees(List<Structure> structures, String axes) {
        boolean agrees = true;
        for (StructureKind kind : List.of(StructureKind.RIB, StructureKind.LUNG, StructureKind.COSTAL_CARTILAGE)) {
            double[] right = centre(structures, kind, Side.RIGHT, 0, 12);
            double[] left = centre(structures, kind, Side.LEFT, 0, 12);
            if (right != null && left != null) {
                agrees &= (left[0] > right[0]) == (axes.charAt(0) == 'L');
            }
        }
        for (StructureKind kind : List.of(StructureKind.RIB, StructureKind.VERTEBRA)) {
            double[] upper = centre(structures, kind, null, 1, 6);
            double[] lower = centre(structures, kind, null, 9, 17);
            if (upper != null && lower != null) {
                agrees &= upper[2] > lower[2];
            }
        }
        return agrees;
    }

    private static double extent(List<Structure> structures, int axis) {
        double[] box = BoundingBoxes.of(structures.stream().map(Structure::mesh));
        return structures.isEmpty() ? 0 : box[3 + axis] - box[axis];
    }

    /** Describes the difference if the detected axes differ from these; empty if they agree or cannot be detected. */
    Optional<String> axesMismatch(List<Structure> structures) {
        String seen = detectedAxes(structures);
        return determinant(seen) == 0 || seen.equals(axes)
                ? Optional.empty()
                : Optional.of("axes: stated as " + axes + ", but the structures' names and places give " + seen);
    }

    /** Axes from the names and positions of the structures; a question mark for each undetermined axis. */
    private static String detectedAxes(List<Structure> structures) {
        double[] right = centre(structures, StructureKind.RIB, Side.RIGHT, 1, 12);
        double[] left = centre(structures, StructureKind.RIB, Side.LEFT, 1, 12);
        double[] upper = centre(structures, StructureKind.RIB, null, 1, 5);
        double[] lower = centre(structures, StructureKind.RIB, null, 8, 12);
        double[] spine = centre(structures, StructureKind.VERTEBRA, null, 1, 12);
        double[] front = centre(structures, StructureKind.STERNUM, null, 0, 0);
        if (right == null || left == null || upper == null || lower == null || spine == null || front == null) {
            return UNKNOWN_AXES;
        }
        char[] letters = UNKNOWN_AXES.toCharArray();
        markAxis(letters, left, right, 'L', 'R');
        markAxis(letters, upper, lower, 'S', 'I');
        markAxis(letters, spine, front, 'P', 'A');
        return new String(letters);
    }

    private static double detectUnit(List<Structure> structures, String axes) {
        return unitOfCage(structures, axes)
                .orElseThrow(() -> new IllegalArgumentException(Numbers.format(
                        "units: found a rib cage %.4g units wide, expected 100 to 500 mm (or that in cm or m)",
                        cageWidth(structures, axes))));
    }

    private static OptionalDouble unitOfCage(List<Structure> structures, String axes) {
        return unit(cageWidth(structures, axes), MIN_CAGE_WIDTH_MM, MAX_CAGE_WIDTH_MM);
    }

    /** The unit, mm, in which a size lies within a range. */
    private static OptionalDouble unit(double size, double minMm, double maxMm) {
        return DoubleStream.of(1, 10, 1000)
                .filter(unit -> size * unit >= minMm && size * unit <= maxMm)
                .findFirst();
    }

    private static void markAxis(char[] letters, double[] positive, double[] negative, char plus, char minus) {
        int best = 0;
        for (int i = 1; i < 3; i++) {
            if (Math.abs(positive[i] - negative[i]) > Math.abs(positive[best] - negative[best])) {
                best = i;
            }
        }
        letters[best] = positive[best] > negative[best] ? plus : minus;
    }

    private static double[] centre(List<Structure> all, StructureKind kind, Side side, int from, int to) {
        double[] sum = new double[3];
        int count = 0;
        for (Structure s : all) {
            if (s.kind() == kind && (side == null || s.side() == side) && s.level() >= from && s.level() <= to) {
                double[] p = s.mesh().positions();
                for (int i = 0; i < p.length; i++) {
                    sum[i % 3] += p[i];
                }
                count += p.length / 3;
            }
        }
        return count == 0 ? null : new double[] {sum[0] / count, sum[1] / count, sum[2] / count};
    }

    private static double cageWidth(List<Structure> all, String axes) {
        int axis = Math.max(axes.indexOf('L'), axes.indexOf('R'));
        double[] box = BoundingBoxes.of(
                all.stream().filter(s -> s.kind() == StructureKind.RIB).map(Structure::mesh));
        return box[3 + axis] - box[axis];
    }
}
