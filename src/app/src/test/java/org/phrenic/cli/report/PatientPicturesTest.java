package org.phrenic.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The pictures of each patient are files of their own. */
class PatientPicturesTest {
    @Test
    void patientsWithTheSameLettersHaveOtherFiles() {
        List<String> patients = List.of("M\u00fcller", "M\u00f6ller", "\u0418\u0432\u0430\u043d", "Patient 4");
        assertThat(IntStream.range(0, patients.size()).mapToObj(p -> PatientPictures.fileName(p + 1, patients.get(p))))
                .containsExactly("1-m-ller", "2-m-ller", "3", "4-patient-4");
    }
}
