package org.phrenic.patient.registration;

import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.PatientStructure;

/**
 * A structure that scan and template have.
 *
 * @param organ the structure of the scan; its first part where it has several
 * @param scan surface in the scan, mm; of several parts all
 * @param template surface of the template at its original place, mm
 */
record SharedStructure(PatientStructure organ, TriangleMesh scan, TriangleMesh template, boolean isComplete) {
    StructureKind kind() {
        return organ.structure().kind();
    }

    Side side() {
        return organ.structure().side();
    }

    int level() {
        return organ.structure().level();
    }

    String cutAt() {
        return organ.scan().map(PatientStructure.Scan::cutAt).orElse("");
    }

    Optional<PatientStructure.Scan> origin() {
        return organ.scan();
    }
}
