package org.phrenic.mesh.io;

import java.io.ByteArrayInputStream;
import java.io.InputStreamReader;
import java.io.SequenceInputStream;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/**
 * The XML part of a VTP file: number formats, pieces with their arrays, and the start of appended data. Raw appended
 * data is not XML, so it is removed before parsing.
 */
final class VtpDocument {
    private static final String TAIL = "</AppendedData></VTKFile>";

    private final String file;
    private final byte[] bytes;
    private final int appendedTagEnd;
    private final XMLStreamReader xml;
    private boolean rootSeen;
    private Piece piece;
    private String section = "";

    /** Byte order of all binary numbers. */
    ByteOrder order = ByteOrder.LITTLE_ENDIAN;
    /** Type of the lengths before binary data: UINT32 or UINT64. */
    ScalarType headerType = ScalarType.UINT32;
    /** What packs binary data, block by block, such as vtkZLibDataCompressor; empty if nothing does. */
    String compressor = "";
    /** Number of bytes up to and including the underscore of AppendedData; -1 without appended data. */
    int appended = -1;
    /** Whether appended data is raw instead of base64. */
    boolean appendedRaw;

    final List<Piece> pieces = new ArrayList<>();

    /**
     * One DataArray element.
     *
     * @param text its content, for the formats ascii and binary
     * @param offset its start in the appended data, for the format appended
     */
    record DataArray(String name, ScalarType type, String format, long offset, String text, int line) {}

    /**
     * One Piece element. The keys of {@code arrays} are "Points", "Polys/connectivity", "Polys/offsets",
     * "Strips/connectivity" and "Strips/offsets".
     */
    record Piece(int line, long points, long polys, long strips, Map<String, DataArray> arrays) {}

    private VtpDocument(String file, byte[] bytes) throws XMLStreamException {
        this.file = file;
        this.bytes = bytes;
        this.appendedTagEnd = appendedTagEnd();
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        int length = appendedTagEnd < 0 ? bytes.length : appendedTagEnd;
        String tail = appendedTagEnd < 0 ? "" : TAIL;
        // The reader replaces bytes that are not UTF-8, because the parser would print messages about them.
        this.xml = factory.createXMLStreamReader(new InputStreamReader(
                new SequenceInputStream(
                        new ByteArrayInputStream(bytes, 0, length),
                        new ByteArrayInputStream(tail.getBytes(StandardCharsets.US_ASCII))),
                StandardCharsets.UTF_8));
    }

    static VtpDocument read(String file, byte[] bytes) {
        try {
            VtpDocument document = new VtpDocument(file, bytes);
            document.readDocument();
            return document;
        } catch (XMLStreamException notXml) {
            int line = notXml.getLocation() == null ? 1 : notXml.getLocation().getLineNumber();
            throw new BadInputException(
                    file + ": line " + line + ": found XML that breaks off or is not well-formed, expected a VTP file",
                    notXml);
        }
    }

    private int appendedTagEnd() {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        int tag = text.indexOf("<AppendedData");
        int end = tag < 0 ? -1 : text.indexOf('>', tag);
        return tag < 0 ? -1 : end < 0 ? bytes.length : end + 1;
    }

    private void readDocument() throws XMLStreamException {
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.DTD -> throw badInput("found a DOCTYPE, expected none in a VTP file");
                case XMLStreamConstants.START_ELEMENT -> startElement(xml.getLocalName());
                case XMLStreamConstants.END_ELEMENT -> {
                    if (xml.getLocalName().equals("Piece")) {
                        piece = null;
                    }
                }
                default -> {
                    // Text between elements, comments.
                }
            }
        }
    }

    private void startElement(String name) throws XMLStreamException {
        if (!rootSeen) {
            readRoot(name);
            return;
        }
        switch (name) {
            case "Piece" -> {
                long polys = count("NumberOfPolys");
                long strips = count("NumberOfStrips");
                piece = new Piece(line(), count("NumberOfPoints"), polys, strips, new LinkedHashMap<>());
                pieces.add(piece);
                section = "";
            }
            case "Points", "Polys", "Strips", "Verts", "Lines", "PointData", "CellData", "FieldData" -> section = name;
            case "DataArray" -> {
                if (piece != null && section.equals("Points")) {
                    add("Points", 3);
                } else if (piece != null && (section.equals("Polys") || section.equals("Strips"))) {
                    add(section + "/" + attribute("Name", ""), 1);
                }
            }
            case "AppendedData" -> startAppended();
            default -> {
                // Later versions may add elements.
            }
        }
    }

    private void readRoot(String name) {
        rootSeen = true;
        String type = attribute("type", "");
        if (!name.equals("VTKFile") || !type.equals("PolyData")) {
            throw badInput("found <" + name + " type=" + Numbers.quote(type) + ">, expected <VTKFile type='PolyData'>");
        }
        String byteOrder = attribute("byte_order", "LittleEndian");
        order = switch (byteOrder) {
            case "LittleEndian" -> ByteOrder.LITTLE_ENDIAN;
            case "BigEndian" -> ByteOrder.BIG_ENDIAN;
            default -> throw unexpected("byte_order", byteOrder, "LittleEndian or BigEndian");
        };
        String header = attribute("header_type", "UInt32");
        headerType = switch (header) {
            case "UInt32" -> ScalarType.UINT32;
            case "UInt64" -> ScalarType.UINT64;
            default -> throw unexpected("header_type", header, "UInt32 or UInt64");
        };
        compressor = attribute("compressor", "");
    }

    private void add(String key, int components) throws XMLStreamException {
        int line = line();
        String found = attribute("NumberOfComponents", "1");
        if (!found.equals(Integer.toString(components))) {
            throw badInput(
                    "found NumberOfComponents " + Numbers.quote(found) + " for " + key + ", expected " + components);
        }
        String typeName = attribute("type", "");
        ScalarType type = Arrays.stream(ScalarType.values())
                .filter(t -> t.name().equalsIgnoreCase(typeName))
                .findFirst()
                .orElseThrow(() -> unexpected("type", typeName, "Int8 to Float64"));
        String format = attribute("format", "ascii");
        if (!format.equals("ascii") && !format.equals("binary") && !format.equals("appended")) {
            throw unexpected("format", format, "ascii, binary or appended");
        }
        long offset = format.equals("appended") ? count("offset") : 0;
        piece.arrays().put(key, new DataArray(key, type, format, offset, ownText(), line));
    }

    /** The text of the element without that of its child elements (VTK adds InformationKey elements). */
    private String ownText() throws XMLStreamException {
        StringBuilder text = new StringBuilder();
        int depth = 1;
        while (depth > 0) {
            switch (xml.next()) {
                case XMLStreamConstants.START_ELEMENT -> depth++;
                case XMLStreamConstants.END_ELEMENT -> depth--;
                case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA, XMLStreamConstants.SPACE -> {
                    if (depth == 1) {
                        text.append(xml.getTextCharacters(), xml.getTextStart(), xml.getTextLength());
                    }
                }
                default -> {
                    // Comments.
                }
            }
        }
        return text.toString();
    }

    private void startAppended() {
        String encoding = attribute("encoding", "");
        if (!encoding.equals("raw") && !encoding.equals("base64")) {
            throw badInput("found encoding " + Numbers.quote(encoding) + " of AppendedData, expected raw or base64");
        }
        int at = appendedTagEnd;
        while (at < bytes.length && Character.isWhitespace(bytes[at])) {
            at++;
        }
        if (at >= bytes.length || bytes[at] != '_') {
            throw BadInputException.at(file, "byte " + at, "found no '_', expected one before the appended data");
        }
        appended = at + 1;
        appendedRaw = encoding.equals("raw");
    }

    private String attribute(String name, String absent) {
        String value = xml.getAttributeValue(null, name);
        return value == null ? absent : value.trim();
    }

    private long count(String name) {
        String text = attribute(name, "0");
        return Numbers.parseWhole(text, 0, Long.MAX_VALUE)
                .orElseThrow(() -> unexpected(name, text, "a whole number, 0 or more"));
    }

    private int line() {
        return xml.getLocation().getLineNumber();
    }

    private BadInputException unexpected(String attribute, String found, String expected) {
        return badInput("found " + attribute + " " + Numbers.quote(found) + ", expected " + expected);
    }

    private BadInputException badInput(String problem) {
        return BadInputException.at(file, "line " + line(), problem);
    }
}
