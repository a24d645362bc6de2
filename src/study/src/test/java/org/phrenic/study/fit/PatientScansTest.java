package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.study.paper.PatientStudy;

class PatientScansTest {
    @TempDir
    Path folder;

    private List<PatientScans> found(String... files) throws IOException {
        for (String file : files) {
            Files.createFile(folder.resolve(file));
        }
        return PatientScans.findIn(folder);
    }

    @Test
    void scansOfOnePatientMayHaveDifferentEndings() throws IOException {
        List<PatientScans> pairs = found(
                "anna_expiration.nii.gz",
                "anna_inspiration.mha",
                "berta_expiration.nrrd",
                "berta_inspiration.mha",
                "berta_inspiration.nrrd",
                "berta_inspiration.txt");
        assertThat(pairs)
                .containsExactly(
                        new PatientScans(
                                "anna",
                                folder.resolve("anna_expiration.nii.gz"),
                                folder.resolve("anna_inspiration.mha")),
                        new PatientScans(
                                "berta",
                                folder.resolve("berta_expiration.nrrd"),
                                folder.resolve("berta_inspiration.nrrd")));
        assertThat(pairs).allSatisfy(pair -> assertThatCode(pair::requireBoth).doesNotThrowAnyException());
    }

    @Test
    void aScanKeptInTwoFormatsIsOnePatient() throws IOException {
        assertThat(found("p_expiration.mha", "p_expiration.nii.gz", "p_inspiration.nii.gz"))
                .containsExactly(new PatientScans(
                        "p", folder.resolve("p_expiration.nii.gz"), folder.resolve("p_inspiration.nii.gz")));
    }

    /** The second patient is tried though the first has one scan alone. */
    @Test
    void aPatientOfOneScanTakesNoPlaceInAReproduction() throws IOException {
        List<PatientScans> patients = found("anna_expiration.mha", "berta_expiration.mha", "berta_inspiration.mha");
        PatientStudy study = new PatientStudy(true, (done, total, what) -> {});
        assertThat(study.of(patients, Optional.empty()).failures())
                .anySatisfy(failure -> assertThat(failure).contains("anna", "found no anna_inspiration.*"))
                .anySatisfy(failure -> assertThat(failure).contains("berta_expiration.mha"));
    }

    @Test
    void aScanWithoutItsPartnerIsNamed() throws IOException {
        List<PatientScans> patients = found(
                "anna_exspiration.mha",
                "anna_inspiration.mha",
                "berta_expiration.nii.gz",
                "berta_inspiraton.nii.gz",
                "clara_expiration.mha",
                "clara_inspiration.mha");
        assertThat(patients).extracting(PatientScans::name).containsExactly("anna", "berta", "clara");
        assertThatThrownBy(patients.get(0)::requireBoth)
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("anna_inspiration.mha: found no anna_expiration.* beside it, expected a volume");
        assertThatThrownBy(patients.get(1)::requireBoth)
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("berta_expiration.nii.gz: found no berta_inspiration.* beside it");
        assertThatCode(patients.get(2)::requireBoth).doesNotThrowAnyException();
    }
}
