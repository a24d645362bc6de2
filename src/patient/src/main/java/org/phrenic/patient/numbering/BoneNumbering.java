package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.patient.segmentation.Segmentation;

/** Numbers of the ribs and the vertebrae of a segmentation. */
public final class BoneNumbering {
    private BoneNumbering() {}

    /**
     * Numbers the ribs where their labels do not, after separating them from bones that share a label with them, and
     * brings their numbers and those of the vertebrae into line. To be called before cartilages and after lungs are
     * separated.
     *
     * @return notes if ribs or vertebrae were numbered
     * @throws org.phrenic.file.BadInputException if ribs cannot be told apart
     */
    public static List<String> numberRibs(Segmentation s) {
        List<String> notes = new ArrayList<>();
        SkeletonSplitter.split(s).ifPresent(notes::add);
        RibNumbering.check(s).ifPresent(notes::add);
        VertebraNumbering.check(s).ifPresent(notes::add);
        return notes;
    }
}
