package org.phrenic.mesh.io.volume;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * A label volume read from a file, in LPS and mm.
 *
 * @param grid labels and where they lie
 * @param names of labels, as far as the file gives them
 * @param notes assumptions made where the file is silent, one sentence each
 */
public record LabelVolume(LabelGrid grid, Map<Integer, String> names, List<String> notes) {
    public LabelVolume {
        names = Collections.unmodifiableMap(new TreeMap<>(names));
        notes = List.copyOf(notes);
    }
}
