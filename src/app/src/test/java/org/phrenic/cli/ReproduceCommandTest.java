package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.OutputException;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.study.Attempts;
import org.phrenic.study.fit.PatientScans;
import org.phrenic.study.paper.PatientCase;
import org.phrenic.study.paper.PatientStudy;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import picocli.CommandLine;

/** {@code phrenic reproduce}: one report with everything that the paper prints, or one sentence and nothing written. */
class ReproduceCommandTest {
    @TempDir
    static Path folder;

    private static CommandLineRun quick;
    private static String html;
    private static String markdown;

    @BeforeAll
    static void reproduce() throws IOException {
        quick = CommandLineRun.of(
                "reproduce", "--quick", "--out", folder.resolve("report").toString());
        html = Files.readString(folder.resolve("report/report.html"));
        markdown = Files.readString(folder.resolve("report/report.md"));
    }

    @Test
    void theReportIsMadeAndNamed() {
        assertThat(quick.exitCode()).as(quick.err()).isEqualTo(DrawingHere.exitCode());
        assertThat(quick.out()).startsWith(folder.resolve("report/report.html").toString());
        assertThat(quick.out()).contains(Disclaimer.TEXT);
    }

    @Test
    void everythingThatThePaperPrintsIsFoundInIt() {
        // A quick reproduction looks at no scan: a synthetic patient stands in, and the report says so.
        assertThat(markdown).contains("A synthetic patient stands in", "synthetic | ", "0.74", "0.75");
        assertThat(markdown).doesNotContain("not there yet");
        // The paper's tables 1 and 2, its parameters, its errors, its mesh sizes, in the order of its pages.
        assertThat(List.of(html, markdown)).allSatisfy(report -> assertThat(report)
                .contains("11,359 nodes", "22,722 triangles", "6,633 nodes", "13,267 triangles")
                .contains("8.13", "10.41", "12.79", "8.56", "10.69", "13.07")
                .contains("8.24", "10.93", "13.27", "9.68", "11.76", "14.70")
                .contains("20,909", "16,023", "12,047")
                .contains("5.8 ± 5", "4.29 ± 3.6", "16 ± 9.4", "12 ± 6.7")
                .contains("4th intercostal space", "T8 to T9")
                .contains("Fig. 1", "Fig. 2", "Fig. 3", "Fig. 4", "Fig. 5", "Table 1", "Table 2")
                .contains(Disclaimer.TEXT));
    }

    @Test
    void everyPictureHasWordsAndLiesBesideIt() throws Exception {
        assumeThat(quick.exitCode()).as("something here draws").isEqualTo(ExitCode.SUCCESS);
        Document page = DocumentBuilderFactory.newDefaultInstance()
                .newDocumentBuilder()
                .parse(folder.resolve("report/report.html").toFile());
        NodeList pictures = page.getElementsByTagName("img");
        assertThat(pictures.getLength()).isEqualTo(14);
        for (int i = 0; i < pictures.getLength(); i++) {
            Element picture = (Element) pictures.item(i);
            assertThat(picture.getAttribute("alt")).isNotBlank();
            assertThat(folder.resolve("report").resolve(picture.getAttribute("src")))
                    .isRegularFile();
            assertThat(markdown).contains("](" + picture.getAttribute("src") + ")");
        }
    }

    /** A folder that has a report is complete: an earlier one does not stand beside other pictures. */
    @Test
    void anEarlierReportGoesBeforeTheFirstPictureIsWritten() throws IOException {
        Path out = Files.createDirectory(folder.resolve("again"));
        Path page = Files.writeString(out.resolve("report.html"), "of an earlier reproduction");
        Path text = Files.writeString(out.resolve("report.md"), "of an earlier reproduction");
        Files.writeString(out.resolve("pictures"), "a file where the folder of pictures should be");
        ReproduceCommand command = new ReproduceCommand();
        new CommandLine(command).parseArgs("--quick", "--out", out.toString());
        FigureImage figure = new FigureImage("fig1", "", "", new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB));
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> command.replacePictures(Map.of(1, List.of(figure))));
        assertThat(page).doesNotExist();
        assertThat(text).doesNotExist();
    }

    @Test
    void nothingIsLeftOpenInAText() {
        assertThat(markdown).doesNotContain("NaN", "null", "%s", "%d", "Infinity");
    }

    @Test
    void aFolderThatCannotBeMadeIsRefusedBeforeAnythingIsMeasured() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "here first");
        CommandLineRun refused =
                CommandLineRun.of("reproduce", "--out", file.resolve("report").toString());
        assertThat(refused.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(refused.err()).hasLineCount(1).contains("expected a folder");
        assertThat(file).hasContent("here first");
    }

    @Test
    void withoutAFolderItSaysSo() {
        CommandLineRun refused = CommandLineRun.of("reproduce");
        assertThat(refused.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(refused.err()).contains("--out");
    }

    @Test
    void aFolderWithoutPairsOfScansIsRefusedBeforeAnythingIsMeasured() throws IOException {
        Path empty = Files.createDirectory(folder.resolve("empty"));
        assertRefused("no pair of volumes", "--patients", empty.toString());
        assertRefused("no folder", "--patients", folder.resolve("none").toString());
        assertRefused("no --patients", "--axes", "LPS");
        assertRefused("--axes: found 'LLS'", "--axes", "LLS", "--patients", empty.toString());
    }

    @Test
    void aReproductionThatCannotBeMadeLeavesAnEarlierReport() throws IOException {
        Path out = Files.createDirectory(folder.resolve("earlier"));
        Path page = Files.writeString(out.resolve("report.html"), "of an earlier reproduction");
        Path text = Files.writeString(out.resolve("report.md"), "of an earlier reproduction");
        CommandLineRun refused = CommandLineRun.of("reproduce", "--out", out.toString(), "--patients", out + "/none");
        assertThat(refused.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(page).hasContent("of an earlier reproduction");
        assertThat(text).hasContent("of an earlier reproduction");
    }

    @Test
    void aScanThatCannotBeUsedIsNamedAndTheStudyGoesOn() throws IOException {
        Path scans = Files.createDirectory(folder.resolve("scans"));
        Files.writeString(scans.resolve("anna_expiration.nii.gz"), "no scan");
        Files.writeString(scans.resolve("anna_inspiration.nii.gz"), "no scan");
        Attempts<PatientCase> cases =
                new PatientStudy(true, (done, of, what) -> {}).of(PatientScans.findIn(scans), Optional.empty());
        assertThat(cases.results()).isEmpty();
        assertThat(cases.failures())
                .singleElement()
                .asString()
                .startsWith("anna: ")
                .contains("_expiration.nii.gz");
    }

    private static void assertRefused(String part, String... options) {
        String[] args = new String[3 + options.length];
        args[0] = "reproduce";
        args[1] = "--out";
        args[2] = folder.resolve("nothing").toString();
        System.arraycopy(options, 0, args, 3, options.length);
        CommandLineRun refused = CommandLineRun.of(args);
        assertThat(refused.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(refused.err()).hasLineCount(1).contains(part, "expected");
        assertThat(folder.resolve("nothing")).doesNotExist();
    }
}
