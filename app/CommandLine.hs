{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : CommandLine
-- Description : What may be asked on the command line
--
-- A parser for each command, and one for each kind of value. What they read is a call: the work itself, which only
-- waits for a journal to tell of it. Each option stands beside the text that explains it, in English and French.
module CommandLine
  ( -- * What was asked
    Call (..),
    Settings (..),

    -- * Reading it
    asked,
  )
where

import Control.Applicative (many, optional, some, (<|>))
import Data.Int (Int32)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Data.Version (showVersion)
import Dioptre.Command.Check (check, checkWithOriginal)
import Dioptre.Command.Compare (compare)
import Dioptre.Command.Conform (Trial (..), conform)
import Dioptre.Command.Explain (explain)
import Dioptre.Command.Format (Format (..), formatNames)
import Dioptre.Command.Info (info)
import Dioptre.Command.Journal (Journal, journalLanguage)
import Dioptre.Command.New (new)
import Dioptre.Command.Oracle (oracle)
import Dioptre.Command.Render (Options (..), Output (..), render)
import Dioptre.Command.View (ViewOptions (..), viewScene)
import Dioptre.Conformance.Oracle (profiles)
import Dioptre.Conformance.Suite (Selection (..))
import Dioptre.Files.Number (PictureNumber)
import Dioptre.Source.Language (Language, inLanguage, languageNames)
import Dioptre.Syntax.Value (integer, real)
import Options.Applicative hiding (info, many, optional, some, (<|>))
import qualified Options.Applicative as Options
import Paths_dioptre (version)
import System.Environment (getProgName)
import System.Exit (ExitCode (..), exitWith)
import System.IO (hPutStr, stderr)
import Usage (Known (..), commandFirst, inWords, optionsOf)
import Prelude hiding (compare)

-------------------------------------------------------------------------------
-- What was asked

-- | What to do, with the options that every command has.
data Call = Call
  { callSettings :: Settings,
    callWork :: Work
  }

-- | What a command does, given where it tells of it.
type Work = Journal -> IO ExitCode

-- | How to speak, and how many processors to use.
data Settings = Settings
  { settingLanguage :: Maybe Language,
    settingQuiet :: Bool,
    settingThreads :: Maybe Int
  }

-------------------------------------------------------------------------------
-- The whole command line

-- | The call in some arguments, given a language, the first number of pictures, and what is done without a command.
-- Where there is none, prints help, the version, or what is wrong, and ends.
asked :: Language -> PictureNumber -> Work -> [String] -> IO Call
asked l first configured given = case execParserPure defaultPrefs (program l first configured) arguments of
  Failure failure -> do
    (text, code) <- renderFailure failure <$> getProgName
    let said = inWords l (known l first) arguments text
    if code == ExitSuccess then putStr said else hPutStr stderr said
    exitWith code
  result -> handleParseResult result
  where
    arguments = commandFirst (known l first) (joinCrop given)

-- | The four numbers of @--crop@ as one argument, which is what the option parser can take.
joinCrop :: [String] -> [String]
joinCrop arguments = case arguments of
  "--crop" : rest | (numbers@[_, _, _, _], others) <- splitAt 4 rest -> ("--crop=" <> unwords numbers) : joinCrop others
  "--" : rest -> "--" : rest
  other : rest -> other : joinCrop rest
  [] -> []

-- | Every command, explained in a language; given the first number of pictures, and what is done without a command.
program :: Language -> PictureNumber -> Work -> ParserInfo Call
program l first configured =
  Options.info
    (helpOption l <*> versionOption <*> (commands <|> call (rendering l first <|> pure configured)))
    ( fullDesc
        <> failureCode 2
        <> header
          ( say
              "dioptre - draws the picture that the rays of a scene see"
              "dioptre - dessine l'image que voient les rayons d'une scène"
          )
        <> progDesc
          ( say
              "Without a command, runs what configuration.cfg says; with the path of a scene, renders it."
              "Sans commande, exécute ce que dit configuration.cfg\xA0; avec le chemin d'une scène, la dessine."
          )
        <> footer
          ( say
              ( "Exit codes: 0 done, 1 faults under check or --strict, or a difference, 2 wrong usage,"
                  <> " 3 a file that cannot be read or written, 70 a bug of ours, 130 stopped by Ctrl-C, 143 by SIGTERM, 129 by SIGHUP."
              )
              ( "Codes de sortie\xA0: 0 terminé, 1 fautes avec check ou --strict, ou une différence, 2 mauvais usage,"
                  <> " 3 fichier illisible ou impossible à écrire, 70 erreur de notre part, 130 arrêté par Ctrl-C, 143 par SIGTERM, 129 par SIGHUP."
              )
          )
    )
  where
    say = inLanguage l
    call work = Call <$> settings l <*> work
    versionOption =
      infoOption ("dioptre " <> versionText) $
        long "version" <> explained l "show the version" "afficher la version" <> hidden

    commands = subparser (foldMap entry (commandsOf l first) <> metavar (say "COMMAND" "COMMANDE"))
    entry (name, work, what) = command name (Options.info (helpOption l <*> call work) (progDesc what <> failureCode 2))

-- | What can be written on the command line.
known :: Language -> PictureNumber -> Known
known l first = Known [(name, optionsOf (Call <$> settings l <*> work)) | (name, work, _) <- commandsOf l first] (optionsOf (Call <$> settings l <*> rendering l first))

-- | The commands, and what each is for.
commandsOf :: Language -> PictureNumber -> [(String, Parser Work, String)]
commandsOf l first =
  [ entry "render" (rendering l first) (say "draw a scene" "dessiner une scène"),
    entry "new" (beginning l) $
      say
        "write a scene to start from, NAME.txt, never over another file"
        "écrire une scène de départ, NOM.txt, jamais sur un autre fichier",
    entry "check" (checking l) $
      say
        "tell what is wrong with scenes, and draw nothing"
        "dire ce qui ne va pas dans des scènes, sans dessiner",
    entry "explain" (explaining l) $
      say
        "tell the story of one pixel: its ray, the shapes, the lights, the colour"
        "raconter l'histoire d'un pixel\xA0: son rayon, les formes, les lumières, la couleur",
    entry "view" (viewing l) $
      say
        "show a scene in the browser, where it can be changed and asked about"
        "montrer une scène dans le navigateur, où l'on peut la modifier et l'interroger",
    entry "compare" comparing $
      say
        "compare two scenes or pictures, pixel by pixel"
        "comparer deux scènes ou images, pixel par pixel",
    entry "info" informing $
      say
        "list applications, words and defaults"
        "énumérer applications, mots et valeurs par défaut",
    entry "oracle" answering $
      say
        "answer the conformance protocol, a line for a line"
        "répondre au protocole de conformité, ligne par ligne",
    entry "conform" (conforming l) $
      say
        "run the conformance suite against a port, a program that answers the protocol"
        "soumettre un portage, un programme qui répond au protocole, à la suite de conformité"
  ]
  where
    say = inLanguage l
    entry name work what = (name, work, what)

-- | The version of this program.
versionText :: String
versionText = showVersion version

helpOption :: Language -> Parser (a -> a)
helpOption l =
  abortOption (ShowHelpText Nothing) $
    long "help" <> short 'h' <> explained l "show this text" "afficher ce texte" <> hidden

-- | The options that every command has.
settings :: Language -> Parser Settings
settings l = Settings <$> optional language <*> quiet <*> optional threads
  where
    language =
      option languageNamed $
        long "language" <> metavar "en|fr" <> explained l "the language of messages" "la langue des messages"
    quiet =
      switch $
        long "quiet" <> short 'q'
          <> explained l "only the result, and what prevents it" "seulement le résultat, et ce qui l'empêche"
    threads =
      option (atLeast l 1) $
        long "threads" <> metavar "N"
          <> explained l "use N processors at most (default: all)" "utiliser N processeurs au plus (par défaut\xA0: tous)"

-------------------------------------------------------------------------------
-- The commands

-- | @render@, which is also what is done with a scene alone.
rendering :: Language -> PictureNumber -> Parser Work
rendering l first = flip render <$> options
  where
    options =
      Options <$> scene <*> output <*> size "width" (inLanguage l "W" "L") <*> size "height" "H" <*> optional sampling
        <*> optional crop
        <*> strict
    output = maybe (Numbered first) ToFile <$> optional file
    file =
      strOption $
        long "output" <> short 'o' <> metavar (inLanguage l "FILE.png" "FICHIER.png") <> action "file"
          <> explained
            l
            "where the picture goes (default: NAME_NNN.png here, never over another)"
            "où va l'image (par défaut\xA0: NOM_NNN.png ici, jamais sur une autre)"
    size name letter =
      optional . option (atLeast l 1) $
        long name <> metavar letter <> explained l "instead of the scene's" "au lieu de celle de la scène"
    sampling =
      option (atLeast l 1) $
        long "sampling" <> metavar "N" <> explained l "rays through each pixel" "rayons par pixel"
    crop =
      option (fourNumbers l) $
        long "crop" <> metavar (inLanguage l "X Y W H" "X Y L H")
          <> explained l "only this part: from column X, row Y" "seulement cette partie, depuis la colonne X, ligne Y"
    strict =
      switch $
        long "strict" <> explained l "draw nothing if the scene has faults" "ne rien dessiner si la scène a des fautes"

-- | @new@.
beginning :: Language -> Parser Work
beginning l = flip new <$> path (inLanguage l "NAME" "NOM")

-- | @check@.
checking :: Language -> Parser Work
checking l = work <$> original <*> format l <*> some (path "SCENE...")
  where
    work alsoOriginal printed scenes journal =
      (if alsoOriginal then checkWithOriginal else check) journal printed scenes
    original =
      switch $
        long "original"
          <> explained
            l
            "also tell what the original program does otherwise with a scene"
            "dire aussi ce que le programme d'origine fait autrement d'une scène"

-- | @explain@.
explaining :: Language -> Parser Work
explaining l =
  work <$> format l <*> scene
    <*> place (inLanguage l "COLUMN" "COLONNE") (explained l "from 0 at the left" "de 0, à gauche")
    <*> place (inLanguage l "ROW" "LIGNE") (explained l "from 0 at the top" "de 0, en haut")
  where
    work printed file column row journal = explain journal printed file column row
    place name what = argument (integerFor l name 0) (metavar name <> what)

-- | @view@.
viewing :: Language -> Parser Work
viewing l = work <$> (ViewOptions <$> optional port <*> (not <$> withoutBrowser)) <*> optional scene
  where
    work options file journal = viewScene journal options file
    port =
      option (portNumber l) $
        long "port" <> metavar "N"
          <> explained
            l
            "the port of this machine where the page is (default: any free one)"
            "le port de cette machine où se trouve la page (par défaut\xA0: un port libre)"
    withoutBrowser =
      switch $
        long "no-browser" <> explained l "only print the page's address" "afficher seulement l'adresse de la page"

-- | @compare@.
comparing :: Parser Work
comparing = work <$> path "A" <*> path "B"
  where
    work a b journal = compare journal a b

-- | @info@.
informing :: Parser Work
informing = pure (\journal -> ExitSuccess <$ Text.putStr (info (journalLanguage journal)))

-- | @oracle@.
answering :: Parser Work
answering = pure (const (oracle (Text.pack versionText)))

-- | @conform@.
conforming :: Language -> Parser Work
conforming l = flip conform <$> trial
  where
    trial =
      Trial <$> selection <*> seconds <*> format l <*> optional suite
        <*> path (inLanguage l "COMMAND" "COMMANDE")
        <*> many (strArgument (metavar "ARGUMENT"))
    selection = Selection <$> many profile <*> optional rule <*> optional aCase
    profile =
      strOption $
        long "profile" <> metavar "P" <> completeWith (map (Text.unpack . fst) profiles)
          <> explained l "only this profile (may be repeated)" "seulement ce profil (peut être répété)"
    rule =
      strOption $
        long "rule" <> metavar "R"
          <> explained
            l
            "only this rule, or the rules whose labels begin so"
            "seulement cette règle, ou celles dont le nom commence ainsi"
    aCase = strOption (long "case" <> metavar "C" <> explained l "only this case" "seulement ce cas")
    seconds =
      option (positiveReal l) $
        long "timeout" <> metavar "S" <> value 10
          <> explained
            l
            "seconds that the port may be silent (default: 10)"
            "secondes pendant lesquelles le portage peut se taire (par défaut\xA0: 10)"
    suite =
      strOption $
        long "suite" <> metavar (inLanguage l "FOLDER" "DOSSIER") <> action "directory"
          <> explained
            l
            "the folder of the suite (default: conformance here, or in the nearest folder around)"
            ( "le dossier de la suite (par défaut\xA0: conformance ici, ou dans le dossier le plus proche"
                <> " qui contient celui-ci)"
            )

-------------------------------------------------------------------------------
-- What several commands have

scene :: Parser FilePath
scene = path "SCENE"

path :: String -> Parser FilePath
path name = strArgument (metavar name <> action "file")

format :: Language -> Parser Format
format l =
  option (formatNamed l) $
    long "format" <> metavar "text|json" <> value AsText
      <> explained l "how to print (default: text)" "comment afficher (par défaut\xA0: text)"

-- | What an option or an argument is for, in English and French.
explained :: Language -> String -> String -> Mod f a
explained l en fr = help (inLanguage l en fr)

-------------------------------------------------------------------------------
-- Values

-- | An integer that is not less than a bound. The greatest is that of the scene language.
atLeast :: Language -> Int -> ReadM Int
atLeast l = integerFor l ""

-- | The same for an argument, which has a name.
integerFor :: Language -> String -> Int -> ReadM Int
integerFor l name least = valued (called <> wanted) $ \text -> case integer text of
  Right n | n >= least -> Just n
  _ -> Nothing
  where
    called = if null name then "" else name <> inLanguage l ": " "\xA0: "
    wanted = inLanguage l "an integer from " "un entier de " <> show least <> inLanguage l " to " " à " <> show (maxBound :: Int32)

fourNumbers :: Language -> ReadM (Int, Int, Int, Int)
fourNumbers l = valued wanted $ \text -> case traverse integer (Text.words text) of
  Right [x, y, w, h] -> Just (x, y, w, h)
  _ -> Nothing
  where
    wanted =
      inLanguage
        l
        "four integers: column, row, width, height"
        "quatre entiers\xA0: colonne, ligne, largeur, hauteur"

portNumber :: Language -> ReadM Int
portNumber l = valued wanted $ \text -> case integer text of
  Right n | n > 0 && n < 65536 -> Just n
  _ -> Nothing
  where
    wanted = inLanguage l "an integer from 1 to 65535" "un entier de 1 à 65535"

positiveReal :: Language -> ReadM Double
positiveReal l = valued wanted $ \text -> case real text of
  Right x | x > 0 -> Just x
  _ -> Nothing
  where
    wanted = inLanguage l "a number greater than 0" "un nombre supérieur à 0"

formatNamed :: Language -> ReadM Format
formatNamed l = valued (inLanguage l "text or json" "text ou json") (`lookup` formatNames)

languageNamed :: ReadM Language
languageNamed = valued "en, fr" ((`lookup` languageNames) . Text.toLower)

-- | A value that is made of a text; where it cannot be, what is wanted is said.
valued :: String -> (Text -> Maybe a) -> ReadM a
valued wanted make = eitherReader (maybe (Left wanted) Right . make . Text.pack)
