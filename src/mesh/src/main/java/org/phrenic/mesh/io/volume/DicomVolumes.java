package org.phrenic.mesh.io.volume;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.dicom.DicomDataSet;
import org.phrenic.mesh.io.dicom.DicomFile;
import org.phrenic.mesh.io.dicom.DicomTag;

/** Reader of DICOM objects by their class: segmentations and structure sets are labels, others images. */
final class DicomVolumes {
    private static final String SEGMENTATION = "1.2.840.10008.5.1.4.1.1.66.4";
    private static final String LABEL_MAP = "1.2.840.10008.5.1.4.1.1.66.7";
    private static final String STRUCTURE_SET = "1.2.840.10008.5.1.4.1.1.481.3";

    private DicomVolumes() {}

    /** Whether a file is DICOM: by its ending, or by its content if its name has no ending of letters. */
    static boolean isDicom(Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        return name.endsWith(".dcm") || (!name.matches(".*\\.[a-z][a-z0-9]*") && DicomFile.isDicom(file));
    }

    /** Whether a DICOM file is a segmentation or a structure set. */
    static boolean holdsLabels(Path path) {
        return List.of(SEGMENTATION, LABEL_MAP, STRUCTURE_SET)
                .contains(DicomFile.read(path).dataSet().text(DicomTag.SOP_CLASS_UID, ""));
    }

    static LabelVolume labels(Path path) {
        DicomFile file = DicomFile.read(path);
        DicomDataSet object = file.dataSet();
        return switch (object.text(DicomTag.SOP_CLASS_UID)) {
            case SEGMENTATION, LABEL_MAP -> DicomSegmentation.read(file);
            case STRUCTURE_SET -> StructureSet.read(path, object);
            default ->
                throw new BadInputException(
                        path + ": found a DICOM object without labels, expected a segmentation or a structure set");
        };
    }

    static ImageVolume image(Path path) {
        return DicomSeries.readFile(DicomFile.read(path));
    }
}
