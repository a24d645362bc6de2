package org.phrenic.mesh.io.volume;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * A label volume read from a file, in LPS axes and mm.
 *
 * @param grid labels and their positions
 * @param names names of labels, if the file contains them
 * @param notes assumptions about missing information, one sentence each
 */
public record LabelVolume(LabelGrid grid, Map<Integer, String> names, List<String> notes) {
    private static final Pattern NUMBER = Pattern.compile("(?i)(segment|seg|label)?[ _.-]*\\d*");

    public LabelVolume {
        names = Collections.unmodifiableMap(new TreeMap<>(names));
        notes = List.copyOf(notes);
    }

    /** Whether a name is a mere number, as programs give to labels without a name: Segment 1, Label 2, 3. */
    public static boolean isNumber(String name) {
        return NUMBER.matcher(name).matches();
    }
}
