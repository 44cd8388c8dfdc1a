package wbv.recording.format;

import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import wbv.recording.DataFault;
import wbv.recording.RowReader;

/** MVNX, the XML that Xsens MVN exports: many segments of one body, read as a stream; external entities are not followed. */
final class MvnxFormat implements Format {

    private static final int DECLARATION = 200;
    private static final Pattern ENCODING = Pattern.compile("<\\?xml [^>?]*?encoding=[\"']([A-Za-z0-9._-]+)[\"']");

    @Override
    public boolean recognises(Head head) {
        return head.first().startsWith("<");
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        try {
            // A reader of ours: the parser's own prints to standard error when bytes are no text.
            XMLStreamReader xml = factory.createXMLStreamReader(new InputStreamReader(source.content(), charset(source)));
            return new MvnxReader(source, xml, context);
        } catch (XMLStreamException wrong) {
            throw fault(source, wrong);
        }
    }

    /** The encoding that the first bytes or the declaration tell; UTF-8 where they tell none. */
    private static Charset charset(Source source) {
        byte[] head = source.head();
        if (head.length > 1 && (head[0] == (byte) 0xFE && head[1] == (byte) 0xFF || head[0] == (byte) 0xFF && head[1] == (byte) 0xFE)) {
            return StandardCharsets.UTF_16;
        }
        Matcher declared = ENCODING.matcher(new String(head, 0, Math.min(head.length, DECLARATION), StandardCharsets.ISO_8859_1));
        if (!declared.lookingAt()) {
            return StandardCharsets.UTF_8;
        }
        try {
            return Charset.forName(declared.group(1));
        } catch (IllegalArgumentException unknown) {
            throw DataFault.at(source.name(), 1, "is in the encoding '" + declared.group(1) + "', which is not known; save it as UTF-8");
        }
    }

    static DataFault fault(Source source, XMLStreamException wrong) {
        long line = wrong.getLocation() == null ? 0 : wrong.getLocation().getLineNumber();
        String message = wrong.getMessage().lines().reduce((one, two) -> two).orElse("").replaceFirst("^Message: ", "");
        return DataFault.at(source.name(), Math.max(line, 1), "is not sound XML: " + message, wrong);
    }
}
