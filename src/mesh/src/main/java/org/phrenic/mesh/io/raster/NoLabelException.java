package org.phrenic.mesh.io.raster;

import org.phrenic.file.BadInputException;

/** A voxel that is no label in a file that was read as labels, as in an image. */
public final class NoLabelException extends BadInputException {
    NoLabelException(String sentence) {
        super(sentence);
    }
}
