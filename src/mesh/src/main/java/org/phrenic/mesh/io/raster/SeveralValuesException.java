package org.phrenic.mesh.io.raster;

import org.phrenic.file.BadInputException;

/** A file of voxels of several values, such as volumes of several times of which none is chosen, vectors or colours. */
public final class SeveralValuesException extends BadInputException {
    /** @param refusal what is wrong, in one sentence */
    SeveralValuesException(BadInputException refusal) {
        super(refusal.getMessage());
    }
}
