package org.phrenic.mesh.io.raster;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** The note about directions along which a file states no spacing. */
public final class MissingSpacing {
    private static final String BEGIN = "no spacing along ";
    private static final List<String> DIRECTIONS = List.of("columns", "rows", "slices");

    private MissingSpacing() {}

    /** Adds a note if the spacing along any of three directions is missing. */
    static void note(List<String> notes, boolean... missing) {
        String along = IntStream.range(0, missing.length)
                .filter(direction -> missing[direction])
                .mapToObj(DIRECTIONS::get)
                .collect(Collectors.joining(", "));
        if (!along.isEmpty()) {
            notes.add(BEGIN + along + ": voxels were taken to be 1 mm wide there");
        }
    }

    /** Whether a file that left these notes states no spacing along some direction. */
    public static boolean isIn(List<String> notes) {
        return notes.stream().anyMatch(note -> note.startsWith(BEGIN));
    }
}
