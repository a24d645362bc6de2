package org.phrenic.mesh.io.raster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.Numbers;

/**
 * Where the header of a NRRD file places voxels: {@code space directions} and {@code space origin} in the unit of
 * {@code space units}, else {@code spacings} in that of {@code units}.
 */
record NrrdPlace(VolumeHeader header) {
    static final String DIMENSION = "space dimension";
    static final String DIRECTIONS = "space directions";
    static final String ORIGIN = "space origin";
    static final String SPACE_UNITS = "space units";
    /** Numbers of a vector of space and time. */
    private static final int WITH_TIME = 4;
    /** Greatest share of a vector that is taken for rounding. */
    private static final double ROUNDING = 1e-6;

    private static final String SPACINGS = "spacings";
    /** What Teem writes for a spacing that it does not know. */
    private static final String UNKNOWN = "nan";

    private static final Pattern VECTOR = Pattern.compile("none|\\(([^)]*)\\)");
    private static final Pattern UNIT = Pattern.compile("\"([^\"]*)\"|(\\S+)");

    /** The vector of each array axis, or "none"; empty if the header has none. */
    List<String> directions() {
        return header.has(DIRECTIONS) ? vectors(DIRECTIONS) : List.of();
    }

    /**
     * The place of the voxels in LPS axes and mm.
     *
     * @param axes the array axes that are spatial directions
     * @param notes receives assumptions about missing information
     */
    VolumeAxes axes(int[] axes, List<String> notes) {
        if (!header.has(DIRECTIONS)) {
            return spaced(axes, notes);
        }
        List<String> vectors = directions();
        double[][] steps = new double[3][];
        for (int i = 0; i < 3; i++) {
            String vector = axes[i] < vectors.size() ? vectors.get(axes[i]) : "none";
            if (vector.equals("none")) {
                throw header.badInput(DIRECTIONS, "found none for axis " + axes[i] + ", expected a vector");
            }
            steps[i] = vector(DIRECTIONS, vector);
        }
        if (hasTime()) {
            checkTime(axes, vectors);
        }
        double[] origin = new double[3];
        if (header.has(ORIGIN)) {
            origin = vector(ORIGIN, vectors(ORIGIN).get(0));
        }
        double[] mm = millimetres(SPACE_UNITS, new int[] {0, 1, 2}, notes);
        return toLps(new VolumeAxes(steps, origin).scaled(mm[0], mm[1], mm[2]), notes);
    }

    /** Refuses vectors that lie in space and in time. */
    private void checkTime(int[] axes, List<String> vectors) {
        for (int axis = 0; axis < vectors.size(); axis++) {
            String[] parts = vectors.get(axis).split(",", -1);
            double space = 0;
            double time = 0;
            for (int i = 0; i < parts.length; i++) {
                double part = Math.abs(Numbers.parse(parts[i].strip()).orElse(0));
                space = Math.max(space, i < 3 ? part : 0);
                time = Math.max(time, i < 3 ? 0 : part);
            }
            int a = axis;
            boolean isSpatial = Arrays.stream(axes).anyMatch(spatial -> spatial == a);
            if (isSpatial ? time > ROUNDING * space : space > ROUNDING * time) {
                throw header.badInput(
                        DIRECTIONS,
                        "found (" + vectors.get(axis) + ") for axis " + axis + ", expected one "
                                + (isSpatial ? "in space" : "in time") + " only");
            }
        }
    }

    private VolumeAxes spaced(int[] axes, List<String> notes) {
        notes.add("no space directions: columns were taken to run to the left, rows to the back, slices up");
        if (!header.has(SPACINGS)) {
            MissingSpacing.note(notes, true, true, true);
            return VolumeAxes.axisAligned(1, 1, 1);
        }
        String[] words = header.text(SPACINGS).split("\\s+", -1);
        double[] spacings = millimetres("units", axes, notes);
        boolean[] missing = new boolean[3];
        for (int i = 0; i < 3; i++) {
            String word = axes[i] < words.length ? words[axes[i]] : "";
            missing[i] = word.equalsIgnoreCase(UNKNOWN);
            spacings[i] = missing[i] ? 1 : spacings[i] * header.number(SPACINGS, word);
        }
        MissingSpacing.note(notes, missing);
        return VolumeAxes.axisAligned(spacings[0], spacings[1], spacings[2]);
    }

    /** Millimetres in the units that a key lists, of three of its axes; 1 where it says nothing. */
    private double[] millimetres(String key, int[] axes, List<String> notes) {
        List<String> units = new ArrayList<>();
        Matcher unit = UNIT.matcher(header.text(key, ""));
        while (unit.find()) {
            units.add((unit.group(1) == null ? unit.group(2) : unit.group(1)).strip());
        }
        double[] mm = {1, 1, 1};
        for (int i = 0; i < 3; i++) {
            String name = axes[i] < units.size() ? units.get(axes[i]) : "";
            mm[i] = switch (name) {
                case "m", "meter", "meters" -> 1000;
                case "cm", "centimeter", "centimeters" -> 10;
                case "", "mm", "millimeter", "millimeters" -> 1;
                case "um", "µm", "μm", "micron", "microns", "micrometer", "micrometers" -> 1e-3;
                default -> {
                    String note = "the unit " + Numbers.quote(name) + " of '" + key
                            + "' is none of m, cm, mm, um: it was taken to be mm";
                    if (!notes.contains(note)) {
                        notes.add(note);
                    }
                    yield 1;
                }
            };
        }
        return mm;
    }

    private String space() {
        return header.text("space", "").toLowerCase(Locale.ROOT);
    }

    /** Whether vectors have a fourth number, which is time. */
    private boolean hasTime() {
        return space().matches(".*-time|[lr][ap]st")
                || (header.has(DIMENSION) && header.integers(DIMENSION)[0] == WITH_TIME);
    }

    private VolumeAxes toLps(VolumeAxes given, List<String> notes) {
        String space = space();
        String still = hasTime() ? space.replaceFirst("(-time|t)$", "") : space;
        return switch (still) {
            case "left-posterior-superior", "lps" -> given;
            case "right-anterior-superior", "ras" -> given.rasToLps();
            case "left-anterior-superior", "las" -> given.scaled(1, -1, 1);
            case "" -> {
                notes.add("no space: axes were taken to be LPS");
                yield given;
            }
            default ->
                throw header.unexpected(
                        "space", space, "left-posterior-superior, right-anterior-superior or left-anterior-superior");
        };
    }

    private List<String> vectors(String key) {
        List<String> vectors = new ArrayList<>();
        Matcher vector = VECTOR.matcher(header.text(key));
        while (vector.find()) {
            vectors.add(vector.group(1) == null ? "none" : vector.group(1));
        }
        if (vectors.isEmpty()) {
            throw header.unexpected(key, header.text(key), "vectors such as (1,0,0)");
        }
        return vectors;
    }

    /** The spatial part of a vector. */
    private double[] vector(String key, String text) {
        String[] parts = text.split(",", -1);
        int expected = hasTime() ? WITH_TIME : 3;
        if (parts.length != expected) {
            throw header.badInput(key, "found a vector of " + parts.length + " numbers, expected " + expected);
        }
        double[] vector = new double[3];
        Arrays.setAll(vector, i -> header.number(key, parts[i].strip()));
        return vector;
    }
}
