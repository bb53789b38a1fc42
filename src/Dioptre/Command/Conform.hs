{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Conform
-- Description : dioptre conform: the conformance suite against a port
--
-- Which cases are asked, and what is said of the answers: for a person each failure in full and a table by
-- profiles, for a program one JSON object with the same. The asking is in "Dioptre.Conformance.Runner".
-- Specification: 0.3 to 0.5.
module Dioptre.Command.Conform
  ( Trial (..),
    conform,
  )
where

import Data.Aeson (Value (..), encode, object, (.=))
import Data.Aeson.Encoding (encodingToLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Containers.ListUtils (nubOrd)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Lazy as LazyText
import qualified Data.Text.Lazy.Encoding as LazyText
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Journal (Journal, journalLanguage, sayFault, toConsole, withProgress)
import Dioptre.Conformance.Compare (describeComparison)
import Dioptre.Conformance.Oracle (profiles)
import Dioptre.Conformance.Protocol (writeValue)
import Dioptre.Conformance.Runner (Complaint (..), Ran (..), Settings (..), runCases, standardSettings)
import Dioptre.Conformance.Suite (Selection (..), SuiteFault (..), findSuite, readSuite, select)
import Dioptre.Conformance.Verdict (Case (..), Reason (..), Score (..), Trouble (..), Verdict (..), abbreviated, isFailure, scoreOf)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (safe)
import qualified Dioptre.Source.Report as Report
import Prettyprinter (Doc, annotate, pretty, vsep)
import Prettyprinter.Render.Terminal (Color (..), bold, color)
import System.Exit (ExitCode (..))
import System.IO (stdout)

-- | What is tried, and how.
data Trial = Trial
  { -- | The cases.
    trialSelection :: Selection,
    -- | How many seconds the port may be silent.
    trialTimeout :: Double,
    -- | How the result is printed.
    trialFormat :: Format,
    -- | The folder of the suite; otherwise the nearest @conformance@ of the working directory and the folders around
    -- it.
    trialSuite :: Maybe FilePath,
    -- | The port: its command.
    trialCommand :: FilePath,
    -- | And its arguments.
    trialArguments :: [String]
  }
  deriving stock (Eq, Show)

-- | Runs the suite against a port, and prints how it did on standard output. Exit codes: 0 nothing failed, 1 something
-- did, 2 no such case, 3 no suite, or no port.
--
-- Spec: conformance.whole, cli.conform.
conform :: Journal -> Trial -> IO ExitCode
conform journal trial =
  maybe (findSuite ".") (pure . Just) (trialSuite trial) >>= \case
    Nothing -> refused 3 (say "there is no folder conformance/vectors here, nor in any folder around; --suite says where it is" "il n'y a de dossier conformance/vectors ni ici, ni dans un dossier qui contient celui-ci\xA0; --suite dit où il est")
    Just folder ->
      readSuite folder >>= \suite -> case select (trialSelection trial) <$> suite of
        Left fault -> refused 3 (suiteFault l fault)
        Right [] -> refused 2 (say "no case of the suite is selected" "aucun cas de la suite n'est choisi")
        Right cases -> do
          ran <- withProgress journal (say "conformance" "conformité") (length cases) $ \step ->
            runCases standardSettings {settingTimeout = trialTimeout trial} step (trialCommand trial) (trialArguments trial) cases
          case ran of
            Left fault -> refused 3 (fileFault l fault)
            Right result -> do
              case trialFormat trial of
                AsText -> toConsole stdout (inWords l result)
                AsJson -> Lazy.putStrLn (encode (inJson l result))
              pure (if any (isFailure . snd) (ranVerdicts result) then ExitFailure 1 else ExitSuccess)
  where
    l = journalLanguage journal
    say = inLanguage l
    refused code text = ExitFailure code <$ sayFault journal text

suiteFault :: Language -> SuiteFault -> Text
suiteFault l fault = case fault of
  Unreadable f -> fileFault l f
  Malformed path why -> Text.pack path <> ": " <> why
  NotUnique name -> inLanguage l "two cases are called " "deux cas s'appellent " <> name

-- | The score of each profile of which there are cases, in their order.
scores :: Ran -> [(Text, Score)]
scores ran =
  [ (profile, mconcat here)
    | profile <- map fst profiles,
      let here = [scoreOf verdict | (c, verdict) <- ranVerdicts ran, caseProfile c == profile],
      not (null here)
  ]

-- | Who was tried, each failure, what was odd, and a table.
inWords :: Language -> Ran -> Doc Report.Style
inWords l ran = vsep (concatMap failure failures <> skipped <> oddities <> table)
  where
    say = inLanguage l
    failures = [(c, reason) | (c, Failed reason) <- ranVerdicts ran]

    failure (c, reason) =
      [ annotate (bold <> color Red) (say "failed " "échec ") <> annotate bold (pretty (caseName c)),
        line (say "rules" "règles") (Text.intercalate ", " (caseRules c)),
        line (say "comment" "remarque") (caseComment c)
      ]
        <> [line (say "finds" "révèle") (Text.intercalate ", " (caseFlags c)) | not (null (caseFlags c))]
        <> [ line "in" (shown (caseInput c)),
             line (say "expected" "attendu") (shown (caseExpected c) <> "  (" <> describeComparison (caseComparison c) <> ")"),
             line (say "got" "obtenu") (reasonInWords l reason),
             ""
           ]
    line label text = "  " <> pretty (Text.justifyLeft 10 ' ' label) <> pretty (safe text)

    skipped = case nubOrd [caseOperation c | (c, NotImplemented _) <- ranVerdicts ran] of
      [] -> []
      operations -> [annotate (color Yellow) (say "not implemented: " "non réalisé\xA0: ") <> pretty (Text.intercalate ", " operations), ""]

    oddities = case ranComplaints ran of
      (0, _) -> []
      (n, first') ->
        [annotate (color Yellow) (pretty (say "remark: " "remarque\xA0: " <> safe (complaintInWords l complaint))) | complaint <- first']
          <> [pretty (say "and " "et " <> number (n - length first') <> say " more like these" " autres de ce genre") | n > length first']
          <> [""]

    table =
      pretty (safe (introductionInWords l (ranIntroduction ran))) :
      row (say "profile" "profil") (say "passed" "réussis") (say "failed" "échoués") (say "not implemented" "non réalisés") :
        [row profile (number p) (number f) (number s) | (profile, Score p f s) <- scores ran <> [(say "all" "tous", total)]]
    total@(Score _ failedCount _) = foldMap snd (scores ran)
    row a b c d =
      pretty (Text.justifyLeft 12 ' ' a)
        <> annotate (color Green) (pretty (Text.justifyRight 9 ' ' b))
        <> (if failedCount > 0 then annotate (color Red) else id) (pretty (Text.justifyRight 9 ' ' c))
        <> annotate (color Yellow) (pretty (Text.justifyRight 17 ' ' d))
    number = Text.pack . show :: Int -> Text

-- | JSON on one line, of which a person can read the whole.
shown :: Value -> Text
shown value
  | Text.length text > 1000 = Text.take 1000 text <> "..."
  | otherwise = text
  where
    text = LazyText.toStrict (LazyText.decodeUtf8 (encodingToLazyByteString (writeValue (abbreviated value))))

reasonInWords :: Language -> Reason -> Text
reasonInWords l reason = case reason of
  Different got place -> shown got <> inLanguage l ", which differs at " ", qui diffère en " <> place
  Refused why -> inLanguage l "an error: " "une erreur\xA0: " <> why
  Unanswered trouble -> inLanguage l "no answer: " "pas de réponse\xA0: " <> troubleInWords l trouble

troubleInWords :: Language -> Trouble -> Text
troubleInWords l trouble = case trouble of
  Ended code words' ->
    (if code < 0 then say "the port was ended by signal " "le programme a été arrêté par le signal " else say "the port ended with exit code " "le programme s'est terminé avec le code ")
      <> shownNumber (abs code)
      <> (if Text.null (Text.strip words') then "" else say "; it said: " "\xA0; il a dit\xA0: " <> Text.strip words')
  Silent seconds -> say "the port was silent for " "le programme s'est tu pendant " <> shownNumber seconds <> " s"
  Babbled text -> say "the port said what is no answer: " "le programme a dit ce qui n'est pas une réponse\xA0: " <> text
  LongLine n -> say "the port said a line longer than " "le programme a dit une ligne de plus de " <> shownNumber n <> say " bytes" " octets"
  GivenUp before -> say "the port was given up" "le programme a été abandonné" <> maybe "" (\t -> " (" <> troubleInWords l t <> ")") before
  where
    say = inLanguage l
    shownNumber :: Show a => a -> Text
    shownNumber = Text.pack . show

complaintInWords :: Language -> Complaint -> Text
complaintInWords l complaint = case complaint of
  NoAnswer why line -> why <> ": " <> line
  UnknownRequest line -> say "an answer to no request: " "une réponse à aucune demande\xA0: " <> line
  NoIntroduction -> say "the port does not answer start" "le programme ne répond pas à start"
  DidNotEnd -> say "the port goes on after the end of its input" "le programme continue après la fin de son entrée"
  where
    say = inLanguage l

introductionInWords :: Language -> Maybe Value -> Text
introductionInWords l = maybe (inLanguage l "a port that does not say who it is" "un programme qui ne dit pas qui il est") shown

-- | The same for programs. Lists are in the order of the cases.
inJson :: Language -> Ran -> Value
inJson l ran =
  object
    [ "port" .= ranIntroduction ran,
      "profiles" .= [object (("profile" .= profile) : counts score) | (profile, score) <- scores ran],
      "total" .= object (counts (foldMap snd (scores ran))),
      "failures" .= [failure c reason | (c, Failed reason) <- ranVerdicts ran],
      "notImplemented" .= [caseName c | (c, NotImplemented _) <- ranVerdicts ran],
      "complaints" .= map (complaintInWords l) (snd (ranComplaints ran))
    ]
  where
    counts (Score p f s) = ["passed" .= p, "failed" .= f, "notImplemented" .= s]
    failure c reason =
      object $
        [ "case" .= caseName c,
          "profile" .= caseProfile c,
          "operation" .= caseOperation c,
          "rules" .= caseRules c,
          "comment" .= caseComment c,
          "flags" .= caseFlags c,
          "in" .= caseInput c,
          "expected" .= caseExpected c,
          "compare" .= describeComparison (caseComparison c)
        ]
          <> case reason of
            Different got place -> ["got" .= got, "differsAt" .= place]
            Refused why -> ["error" .= why]
            Unanswered trouble -> ["trouble" .= troubleInWords l trouble]
