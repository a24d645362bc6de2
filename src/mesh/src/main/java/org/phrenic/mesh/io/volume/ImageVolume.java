package org.phrenic.mesh.io.volume;

import java.util.List;
import org.phrenic.mesh.voxel.ImageGrid;

/**
 * An image volume read from a file, in LPS axes and mm.
 *
 * @param grid values and their positions
 * @param notes assumptions about missing information, one sentence each
 */
public record ImageVolume(ImageGrid grid, List<String> notes) {
    public ImageVolume {
        notes = List.copyOf(notes);
    }
}
