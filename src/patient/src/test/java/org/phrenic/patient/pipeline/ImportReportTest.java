package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

class ImportReportTest {
    private static Map<?, ?> row(DistanceSummary distances) {
        double[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        TriangleMesh mesh = new TriangleMesh(corners, new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
        PatientStructure liver = new PatientStructure(
                new Structure("liver", StructureKind.LIVER, 0, Side.MIDLINE, mesh),
                PatientStructure.Source.SCAN,
                Optional.empty(),
                Optional.of(distances));
        PatientBody body = new PatientBody("patient", List.of(liver), List.of(), List.of());
        Map<String, Object> report = new ImportResult(
                        "patient",
                        Optional.empty(),
                        body,
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        List.of())
                .report();
        return (Map<?, ?>) ((List<?>) report.get("structures")).get(0);
    }

    /** Of a structure whose surface lies at the cut alone there is nothing to compare. */
    @Test
    void noDistanceIsReportedWhereNoneWasMeasured() {
        assertThat(row(DistanceSummary.NONE).keySet())
                .noneMatch(key -> key.toString().startsWith("fit_off_scan"));
        Object mean = row(DistanceSummary.of(new double[] {1, 3})).get("fit_off_scan_mean_mm");
        assertThat(mean).isEqualTo(2.0);
    }
}
