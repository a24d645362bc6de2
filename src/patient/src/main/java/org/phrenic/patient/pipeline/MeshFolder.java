package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.label.LabelNames;

/** Reads a folder of meshes as a body to be completed. */
final class MeshFolder {
    private MeshFolder() {}

    /**
     * Reads the meshes whose names are those of structures, or those that label tables know.
     *
     * @throws org.phrenic.file.BadInputException if the folder or a file in it cannot be used
     */
    static PatientBody read(Path folder, String name) {
        Thorax thorax = ThoraxFolder.loadPart(folder, LabelNames::structure);
        List<PatientStructure> structures = thorax.structures().stream()
                .map(s -> new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        return new PatientBody(name, structures, ExpectedStructures.missing(structures), thorax.notes());
    }
}
