package org.phrenic.mesh.io.dicom;

import java.util.List;
import java.util.Optional;
import org.phrenic.file.BadInputException;

/** What an image of several frames states for each frame, or for all of them (PS3.3, C.7.6.16). */
public final class FunctionalGroups {
    private final DicomDataSet image;
    private final Optional<DicomDataSet> shared;
    private final List<DicomDataSet> perFrame;

    public FunctionalGroups(DicomDataSet image) {
        this.image = image;
        shared = image.first(DicomTag.SHARED_FUNCTIONAL_GROUPS_SEQUENCE);
        perFrame = image.items(DicomTag.PER_FRAME_FUNCTIONAL_GROUPS_SEQUENCE);
    }

    /** Whether the image has any. */
    public boolean arePresent() {
        return shared.isPresent() || !perFrame.isEmpty();
    }

    /** @throws BadInputException if there are functional groups for another number of frames */
    public void checkCount(int frames) {
        if (perFrame.size() != frames) {
            throw image.badInput(
                    DicomTag.PER_FRAME_FUNCTIONAL_GROUPS_SEQUENCE,
                    "found " + perFrame.size() + " items, expected one for each of " + frames + " frames");
        }
    }

    /** The item of a group: that of the frame, else the shared one, if there is one. */
    public Optional<DicomDataSet> find(int frame, DicomTag group) {
        Optional<DicomDataSet> own = perFrame.get(frame).first(group);
        return own.isPresent() ? own : shared.flatMap(all -> all.first(group));
    }

    /** @throws BadInputException if neither the frame nor the shared groups have it */
    public DicomDataSet item(int frame, DicomTag group) {
        return find(frame, group)
                .orElseThrow(() -> new BadInputException(
                        image.file() + ": found no " + group.place() + " for frame " + frame + ", expected one"));
    }
}
