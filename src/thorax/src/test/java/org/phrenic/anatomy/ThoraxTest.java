package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.TriangleMesh;

/** The line that names what the scan of a body does not show. */
class ThoraxTest {
    private static Structure structure(String name) {
        StructureName known = StructureName.parse(name).orElseThrow();
        return new Structure(
                name, known.kind(), known.level(), known.side(), new TriangleMesh(new double[0], new int[0]));
    }

    private static Thorax body(Set<String> notInScan) {
        List<Structure> all = new ArrayList<>();
        for (String name : List.of("rib_05_R", "rib_06_R", "vertebra_T05", "vertebra_T06", "diaphragm", "skin")) {
            all.add(structure(name));
        }
        return new Thorax("patient", all, List.of(), notInScan);
    }

    @Test
    void aBodyThatIsAllScannedNamesNothing() {
        assertThat(body(Set.of()).notInScanSummary()).isEmpty();
    }

    @Test
    void partsOfTheSternumAreOneSternum() {
        List<Structure> all = List.of(
                structure("sternum_body"),
                structure("sternum_xiphoid"),
                structure("costal_cartilage_01_R"),
                structure("costal_cartilage_02_R"));
        Set<String> names = Set.of("sternum_body", "sternum_xiphoid", "costal_cartilage_01_R", "costal_cartilage_02_R");
        assertThat(new Thorax("patient", all, List.of(), names).notInScanSummary())
                .isEqualTo("costal cartilages, sternum");
    }

    @Test
    void structuresAreCountedByKind() {
        assertThat(body(Set.of("rib_05_R", "vertebra_T05", "vertebra_T06", "diaphragm"))
                        .notInScanSummary())
                .isEqualTo("1 of 2 ribs, vertebrae, diaphragm");
    }
}
